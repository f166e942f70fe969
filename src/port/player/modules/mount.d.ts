/** The uniforms that you can set, with their default values. */
export interface Uniforms {}

/** Label, widget and range of a uniform that you can set. */
export interface Control {
  /** Name of the uniform. */
  name: string;
  /** Label for users. */
  label: string;
  kind: 'float' | 'int' | 'bool' | 'color' | 'point' | 'vector' | 'choice' | 'event';
  /** Default value, with one number per component; `min` and `max` are its useful range. */
  value: number[];
  min?: number[];
  max?: number[];
  choices?: { label: string; value: number }[];
}

/** An error: the pass, the line in it, from 1 (0: the whole pass, -1: not in a pass), and the message. */
export interface ShaderError {
  pass: string;
  line: number;
  text: string;
}

export interface MountOptions {
  /** Draw the first frame only; `play()` starts the clock. */
  paused?: boolean;
  /** Seconds at which to start. */
  time?: number;
  /** Width and height in pixels. Default: the displayed size of the canvas. */
  size?: [number, number];
  /** Rendered pixels per device pixel. Default: 1. */
  scale?: number;
  /** Forward mouse, touch and pen input to `iMouse`. Default: true. */
  pointer?: boolean;
  /** Forward keys to a keyboard channel while the canvas has focus. Default: true. */
  keyboard?: boolean;
  /** Play sound. Browsers allow this only after a user gesture. */
  sound?: boolean;
  /**
   * Play even while the canvas cannot be seen. Default: false. Otherwise the shader starts when the canvas is
   * seen and stands still when it is not, and its WebGL context may be given to another one meanwhile.
   */
  hidden?: boolean;
  /** Called if passes do not compile. */
  onError?: (errors: ShaderError[]) => void;
}

export interface Mounted {
  /**
   * Resolves when all passes are compiled and all inputs are loaded, which begins when the canvas is seen.
   * Rejects if the browser gives no WebGL2 context.
   */
  readonly ready: Promise<void>;
  readonly errors: ShaderError[];
  /** Seconds since the start. */
  readonly time: number;
  readonly playing: boolean;
  play(): void;
  pause(): void;
  restart(): void;
  /** Seeks to a time in seconds, at most 30 million. Throws a TypeError if it is not a number. */
  seek(time: number): void;
  /** Restarts and draws the frames 0 to n, at 60 frames per second. */
  renderFrame(n: number): Promise<void>;
  /** Sets the mouse, in pixels from the lower left corner. */
  setMouse(x: number, y: number, down: boolean): void;
  /** Presses or releases a key, by the keyCode of JavaScript. */
  setKey(code: number, down: boolean): void;
  setSound(on: boolean): void;
  /**
   * Sets a number, switch, vector or colour in the code that its author made tunable, within its limits, and
   * recompiles. Rejects with a RangeError for an unknown name, with a TypeError for a value that is not a number.
   */
  setTunable(name: string, value: number | boolean | number[]): Promise<void>;
  /** The uniforms that you can set. A new value applies to the next frame, without recompiling. */
  readonly uniforms: Uniforms;
  /** Labels, widgets and ranges of these uniforms. */
  readonly controls: Control[];
  /** Loads an image, video or audio file into a channel. */
  setInput(pass: number, channel: number, url: string): Promise<void>;
  /** Stops the player and frees its resources. Later calls have no effect. */
  dispose(): void;
}

export function mount(canvas: HTMLCanvasElement, options?: MountOptions): Mounted;
export default mount;

/** The uniforms that are yours to set, with what they are at first. */
export interface Uniforms {}

/** What there is to say of a uniform that is yours to set. */
export interface Control {
  /** Of the uniform. */
  name: string;
  /** What people call it. */
  label: string;
  kind: 'float' | 'int' | 'bool' | 'color' | 'point' | 'vector' | 'choice' | 'event';
  /** As many numbers as it takes, what they are at first, and between which they make sense. */
  value: number[];
  min?: number[];
  max?: number[];
  choices?: { label: string; value: number }[];
}

/** A mistake in the shader: the pass, the line in it from 1 (0: the whole pass, -1: no pass), and what is wrong. */
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
  /** Pixels of the picture; without it the canvas is as sharp as it is shown. */
  size?: [number, number];
  /** Pixels of the picture for each pixel of the device; 1 unless said. */
  scale?: number;
  /** Feed mouse, finger and pen to `iMouse`; true unless said. */
  pointer?: boolean;
  /** Feed keys to a keyboard channel while the canvas has the focus; true unless said. */
  keyboard?: boolean;
  /** Play sound; browsers allow it after a click. */
  sound?: boolean;
  /** Called when passes do not compile. */
  onError?: (errors: ShaderError[]) => void;
}

export interface Mounted {
  /** Resolves when all passes are compiled and all inputs are loaded. */
  readonly ready: Promise<void>;
  readonly errors: ShaderError[];
  /** Seconds since the start. */
  readonly time: number;
  readonly playing: boolean;
  play(): void;
  pause(): void;
  restart(): void;
  /** Goes to a time in seconds, at most 30 million. Throws a TypeError if it is no number. */
  seek(time: number): void;
  /** Restarts and draws the frames 0 to n, sixty a second. */
  renderFrame(n: number): Promise<void>;
  /** Pixels from the lower left corner. */
  setMouse(x: number, y: number, down: boolean): void;
  /** JavaScript's keyCode. */
  setKey(code: number, down: boolean): void;
  setSound(on: boolean): void;
  /**
   * Gives a tunable number another value, within its author's limits, and compiles again. Fails with a
   * RangeError where nothing has this name, with a TypeError if the value is no number.
   */
  setTunable(name: string, value: number): Promise<void>;
  /** The uniforms that are yours to set. A new value is in the next picture, and nothing is compiled. */
  readonly uniforms: Uniforms;
  /** What there is to say of them. */
  readonly controls: Control[];
  /** Puts a picture, film or music onto a channel. */
  setInput(pass: number, channel: number, url: string): Promise<void>;
  /** Ends everything and frees what it holds. What is called afterwards does nothing. */
  dispose(): void;
}

export function mount(canvas: HTMLCanvasElement, options?: MountOptions): Mounted;
export default mount;

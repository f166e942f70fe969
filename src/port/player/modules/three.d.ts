import type { Color, IUniform, Object3D, RawShaderMaterial, Texture, Vector2, Vector3, Vector4, WebGLRenderer } from 'three';

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

export interface Tick {
  /** Seconds since the start. */
  time: number;
  /** Seconds since the previous frame. Default: 1/60. */
  delta?: number;
  /** As `iMouse`: the mouse position, then that of the last click, positive while the button is down. */
  mouse?: [number, number, number, number];
  /** Width and height in pixels. Default: the size of the renderer's canvas. */
  width?: number;
  height?: number;
}

export interface ThreeShader {
  /** Draws the Image on any mesh, in screen coordinates. */
  readonly material: RawShaderMaterial;
  /** Draws it in any scene without your own mesh; required for shaders that draw vertices. */
  readonly object: Object3D;
  /** The uniforms that you can set, shared with `material`. */
  readonly uniforms: Uniforms;
  /** Labels, widgets and ranges of these uniforms. */
  readonly controls: Control[];
  /** Sets the other uniforms and draws the buffers. Call this before each frame. */
  update(renderer: WebGLRenderer, tick: Tick): void;
  /** Sets the texture of a channel of the Image, or of all samplers with a name. */
  setChannel(channel: number | string, texture: Texture): void;
  /** Restarts at frame 0. */
  restart(): void;
  dispose(): void;
}

export function createShader(): ThreeShader;
export default createShader;

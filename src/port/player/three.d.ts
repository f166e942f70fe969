import type { Color, IUniform, Object3D, RawShaderMaterial, Texture, Vector2, Vector3, Vector4, WebGLRenderer } from 'three';

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

export interface Tick {
  /** Seconds since the start. */
  time: number;
  /** Seconds since the frame before; 1/60 unless said. */
  delta?: number;
  /** As `iMouse`: where the mouse is, and where it was pressed, above zero while it is down. */
  mouse?: [number, number, number, number];
  /** Pixels of the picture; those of the renderer's canvas unless said. */
  width?: number;
  height?: number;
}

export interface ThreeShader {
  /** Paints the Image, in the coordinates of the screen, over whatever mesh it is on. */
  readonly material: RawShaderMaterial;
  /** Paints it in any scene, without a mesh of yours; a shader of vertices needs this one. */
  readonly object: Object3D;
  /** The uniforms that are yours to set; those of `material` are the same. */
  readonly uniforms: Uniforms;
  /** What there is to say of them. */
  readonly controls: Control[];
  /** Sets the other uniforms and draws the buffers; call it before each frame. */
  update(renderer: WebGLRenderer, tick: Tick): void;
  /** Puts a texture onto a channel of the Image, or onto all samplers of a name. */
  setChannel(channel: number | string, texture: Texture): void;
  /** Starts again at frame 0. */
  restart(): void;
  dispose(): void;
}

export function createShader(): ThreeShader;
export default createShader;

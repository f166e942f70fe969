import type { RawShaderMaterial, Texture, WebGLRenderer } from 'three';

export interface Tick {
  /** Seconds since the start. */
  time: number;
  /** Seconds since the frame before; 1/60 unless said. */
  delta?: number;
  /** As `iMouse`. */
  mouse?: [number, number, number, number];
  /** Pixels of the picture; those of the renderer's canvas unless said. */
  width?: number;
  height?: number;
}

export interface ThreeShader {
  /** Paints the Image, in the coordinates of the screen, over whatever mesh it is on. */
  readonly material: RawShaderMaterial;
  /** Sets the uniforms and draws the buffers; call it before each frame. */
  update(renderer: WebGLRenderer, tick: Tick): void;
  /** Puts a texture onto a channel of the Image. */
  setChannel(channel: number, texture: Texture): void;
  /** Starts again at frame 0. */
  restart(): void;
  dispose(): void;
}

export function createShader(): ThreeShader;
export default createShader;

// Render targets of passes: pairs of textures, one to write and one to read.

/** Pass index of a buffer that is read but never drawn. It stays empty. */
const UNDRAWN = -1;

/** Whether a channel reads a pass with mipmaps. @param {ProjectData} project @param {number} pass index */
function hasMipmaps(project, pass) {
  const isCube = project.passes[pass]?.kind === 'cubemap';
  /** @param {InputData} input */
  const reads = ({ kind, buffer = UNDRAWN }) =>
    isCube ? kind === 'cubebuffer' : kind === 'buffer' && buffer === pass;
  return project.passes.some((p) => p.inputs.some((i) => i?.filter === 'mipmap' && reads(i)));
}

/** A buffer with 32-bit floats or, like a canvas, with bytes. */
class Buffer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {number} width @param {number} height
   * @param {boolean} isFloat
   */
  constructor(gl, width, height, isFloat) {
    this.gl = gl;
    this.isFloat = isFloat;
    this.width = width;
    this.height = height;
    /** Index of the texture for reading. */
    this.front = 0;
    this.textures = [this.#texture(), this.#texture()];
    this.framebuffer = /** @type {WebGLFramebuffer} */ (gl.createFramebuffer());
  }

  #texture() {
    const gl = this.gl;
    const texture = /** @type {WebGLTexture} */ (gl.createTexture());
    gl.bindTexture(gl.TEXTURE_2D, texture);
    const [format, type] = this.isFloat ? [gl.RGBA32F, gl.FLOAT] : [gl.RGBA8, gl.UNSIGNED_BYTE];
    gl.texImage2D(gl.TEXTURE_2D, 0, format, this.width, this.height, 0, gl.RGBA, type, null);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    return texture;
  }

  get texture() {
    return this.textures[this.front];
  }

  /** Binds the texture for writing as the render target. */
  bind() {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    const back = this.textures[1 - this.front];
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, back, 0);
    gl.viewport(0, 0, this.width, this.height);
  }

  /** Copies the drawn texture to the canvas; requires bytes. */
  show() {
    const { gl, width, height } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Swaps the textures for reading and writing. @param {boolean} hasMipmaps */
  flip(hasMipmaps) {
    this.front = 1 - this.front;
    if (!hasMipmaps) return;
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
    this.gl.generateMipmap(this.gl.TEXTURE_2D);
  }

  /** @param {boolean} hasMipmaps */
  clear(hasMipmaps) {
    const gl = this.gl;
    for (let i = 0; i < 2; i++) {
      this.bind();
      gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
      this.flip(hasMipmaps);
    }
  }

  /**
   * Changes the size. The common lower left part keeps its content.
   * @param {number} width @param {number} height @param {boolean} hasMipmaps
   */
  resize(width, height, hasMipmaps) {
    if (width === this.width && height === this.height) return;
    const gl = this.gl;
    const old = this.textures;
    const kept = [Math.min(width, this.width), Math.min(height, this.height)];
    this.width = width;
    this.height = height;
    this.textures = [this.#texture(), this.#texture()];
    const source = gl.createFramebuffer();
    for (let i = 0; i < 2; i++) {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, source);
      const from = gl.COLOR_ATTACHMENT0;
      gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, from, gl.TEXTURE_2D, old[i], 0);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[i]);
      gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, kept[0], kept[1]);
      if (hasMipmaps) gl.generateMipmap(gl.TEXTURE_2D);
      gl.deleteTexture(old[i]);
    }
    gl.deleteFramebuffer(source);
  }

  dispose() {
    this.textures.forEach((t) => this.gl.deleteTexture(t));
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}

const CUBE_SIZE = 1024;

/** Directions of the faces +X, -X, +Y, -Y, +Z, -Z at their (0,0), (1,0), (1,1) and (0,1). */
const CUBE_CORNERS = [
  [1, 1, 1, 1, 1, -1, 1, -1, -1, 1, -1, 1],
  [-1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1],
  [-1, 1, -1, 1, 1, -1, 1, 1, 1, -1, 1, 1],
  [-1, -1, 1, 1, -1, 1, 1, -1, -1, -1, -1, -1],
  [-1, 1, 1, 1, 1, 1, 1, -1, 1, -1, -1, 1],
  [1, 1, -1, -1, 1, -1, -1, -1, -1, 1, -1, -1],
];

/** A cube map of 1024 x 1024 with 16-bit floats. */
class CubeBuffer {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.front = 0;
    this.textures = [this.#texture(), this.#texture()];
    this.framebuffer = /** @type {WebGLFramebuffer} */ (gl.createFramebuffer());
  }

  #texture() {
    const gl = this.gl;
    const texture = /** @type {WebGLTexture} */ (gl.createTexture());
    const levels = Math.log2(CUBE_SIZE) + 1;
    gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
    gl.texStorage2D(gl.TEXTURE_CUBE_MAP, levels, gl.RGBA16F, CUBE_SIZE, CUBE_SIZE);
    gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    return texture;
  }

  get texture() {
    return this.textures[this.front];
  }

  /** @param {number} face */
  bind(face) {
    const gl = this.gl;
    const side = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
    const back = this.textures[1 - this.front];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, side, back, 0);
    gl.viewport(0, 0, CUBE_SIZE, CUBE_SIZE);
  }

  /** @param {boolean} hasMipmaps */
  flip(hasMipmaps) {
    this.front = 1 - this.front;
    if (!hasMipmaps) return;
    this.gl.bindTexture(this.gl.TEXTURE_CUBE_MAP, this.texture);
    this.gl.generateMipmap(this.gl.TEXTURE_CUBE_MAP);
  }

  /** @param {boolean} hasMipmaps */
  clear(hasMipmaps) {
    for (let i = 0; i < 2; i++) {
      for (let face = 0; face < 6; face++) {
        this.bind(face);
        this.gl.clearBufferfv(this.gl.COLOR, 0, [0, 0, 0, 0]);
      }
      this.flip(hasMipmaps);
    }
  }

  dispose() {
    this.textures.forEach((t) => this.gl.deleteTexture(t));
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}

// A render target: a pair of textures, one to write and one to read.

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

  /** The texels that passes read. */
  save() {
    const { gl, width, height } = this;
    const texels = this.isFloat ? new Float32Array(4 * width * height) : new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    gl.readPixels(0, 0, width, height, gl.RGBA, this.isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, texels);
    return { width, height, texels };
  }

  /** @param {ReturnType<Buffer['save']>} saved @param {boolean} hasMipmaps */
  restore({ width, height, texels }, hasMipmaps) {
    const { gl } = this;
    const [nowWidth, nowHeight] = [this.width, this.height];
    this.resize(width, height, hasMipmaps);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, this.isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, texels);
    if (hasMipmaps) gl.generateMipmap(gl.TEXTURE_2D);
    this.resize(nowWidth, nowHeight, hasMipmaps);
  }

  dispose() {
    this.textures.forEach((t) => this.gl.deleteTexture(t));
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}

parts.Buffer = Buffer;

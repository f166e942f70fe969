// The target of the cube map pass.

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

  /** Draws all faces. @param {PassProgram} program */
  draw(program) {
    CUBE_CORNERS.forEach((corners, face) => {
      this.bind(face);
      program.setFace(corners);
      this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
    });
  }

  /** The texels that passes read, by face. */
  save() {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    return CUBE_CORNERS.map((_, face) => {
      const texels = new Float32Array(4 * CUBE_SIZE * CUBE_SIZE);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, this.texture, 0);
      gl.readPixels(0, 0, CUBE_SIZE, CUBE_SIZE, gl.RGBA, gl.FLOAT, texels);
      return texels;
    });
  }

  /** @param {Float32Array<ArrayBuffer>[]} faces @param {boolean} hasMipmaps */
  restore(faces, hasMipmaps) {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_CUBE_MAP, this.texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    faces.forEach((texels, face) => {
      gl.texSubImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, CUBE_SIZE, CUBE_SIZE, gl.RGBA, gl.FLOAT, texels);
    });
    if (hasMipmaps) gl.generateMipmap(gl.TEXTURE_CUBE_MAP);
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

parts.CubeBuffer = CubeBuffer;

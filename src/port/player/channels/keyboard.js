// The keyboard as a texture of 256 x 3: row 0 holds pressed keys, row 1 keys that were pressed since
// the previous frame, row 2 toggled keys.

class Keyboard {
  constructor() {
    this.data = new Uint8Array(256 * 3);
    this.isStale = false;
  }

  /** @param {number} code the keyCode of JavaScript @param {boolean} isDown */
  set(code, isDown) {
    if (!(code >= 0 && code < 256)) return;
    if (!isDown) {
      this.data[code] = 0;
      this.data[code + 256] = 0;
    } else if (this.data[code] === 0) {
      this.data[code] = 255;
      this.data[code + 256] = 255;
      this.data[code + 512] = 255 - this.data[code + 512];
    }
    this.isStale = true;
  }

  releaseAll() {
    this.data.fill(0, 0, 512);
    this.isStale = true;
  }

  /** The keyboard as a texture of a context. @param {WebGL2RenderingContext} gl */
  texture(gl) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 256, 3, 0, gl.RED, gl.UNSIGNED_BYTE, this.data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    const upload = () => {
      if (!this.isStale) return;
      this.isStale = false;
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 256, 3, gl.RED, gl.UNSIGNED_BYTE, this.data);
    };
    return { texture, upload, dispose: () => gl.deleteTexture(texture) };
  }

  endFrame() {
    if (!this.data.subarray(256, 512).some((v) => v !== 0)) return;
    this.data.fill(0, 256, 512);
    this.isStale = true;
  }
}

parts.Keyboard = Keyboard;

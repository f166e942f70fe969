// The sound pass: 180 seconds, computed once in blocks of 512 x 512 samples.

const SOUND_SECONDS = 180;
const SOUND_SIDE = 512;

class Sound {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {(offset: number) => void} drawBlock draws the block that starts at this sample
   */
  constructor(gl, drawBlock) {
    this.gl = gl;
    this.drawBlock = drawBlock;
    this.left = new Float32Array(SOUND_RATE * SOUND_SECONDS);
    this.right = new Float32Array(SOUND_RATE * SOUND_SECONDS);
    /** Number of computed samples. */
    this.done = 0;
    /** @type {AudioBufferSourceNode | null} */
    this.source = null;
    this.texture = gl.createTexture();
    this.framebuffer = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, SOUND_SIDE, SOUND_SIDE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    const to = gl.COLOR_ATTACHMENT0;
    gl.framebufferTexture2D(gl.FRAMEBUFFER, to, gl.TEXTURE_2D, this.texture, 0);
  }

  get isReady() {
    return this.done >= this.left.length;
  }

  /** Computes the next block. */
  step() {
    if (this.isReady) return;
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, SOUND_SIDE, SOUND_SIDE);
    this.drawBlock(this.done);
    const bytes = new Uint8Array(SOUND_SIDE * SOUND_SIDE * 4);
    gl.readPixels(0, 0, SOUND_SIDE, SOUND_SIDE, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    const count = Math.min(SOUND_SIDE * SOUND_SIDE, this.left.length - this.done);
    for (let i = 0; i < count; i++) {
      this.left[this.done + i] = soundSample(bytes[4 * i], bytes[4 * i + 1]);
      this.right[this.done + i] = soundSample(bytes[4 * i + 2], bytes[4 * i + 3]);
    }
    this.done += count;
  }

  /** Computes the remaining blocks, and yields to the page between them. */
  async finish() {
    while (!this.isReady) {
      this.step();
      await new Promise((resolve) => setTimeout(resolve, 0));
    }
  }

  /**
   * Starts playback at a time, and stops the current one.
   * @param {Devices} devices
   * @param {number} time seconds
   */
  async play(devices, time) {
    this.stop();
    await this.finish();
    const audio = devices.openAudio();
    const buffer = audio.createBuffer(2, this.left.length, SOUND_RATE);
    buffer.copyToChannel(this.left, 0);
    buffer.copyToChannel(this.right, 1);
    this.stop();
    this.source = audio.createBufferSource();
    this.source.buffer = buffer;
    this.source.connect(devices.output ?? audio.destination);
    if (time < SOUND_SECONDS) this.source.start(0, time);
  }

  stop() {
    try {
      this.source?.stop();
    } catch {
      // It was never started.
    }
    this.source?.disconnect();
    this.source = null;
  }

  dispose() {
    this.stop();
    this.gl.deleteTexture(this.texture);
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}

parts.Sound = Sound;

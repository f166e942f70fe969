// One pass made ready to draw: its program, and where its uniforms lie.

class PassProgram {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {WebGLProgram} program
   * @param {PassData} data
   */
  constructor(gl, program, data) {
    this.gl = gl;
    this.program = program;
    this.data = data;
    this.at = uniformLookup(gl, program);
    gl.useProgram(program);
    for (let channel = 0; channel < 4; channel++) {
      gl.uniform1i(this.at(`iChannel${channel}`), channel);
      gl.uniform1i(this.at(`iCh${channel}.sampler`), channel);
    }
    if (!data.uniforms) gl.uniform1f(this.at('iSampleRate'), 44100);
  }

  /**
   * Sets what is the same for all passes of a frame.
   * @param {Frame} frame
   * @param {number} width @param {number} height
   */
  setFrame(frame, width, height) {
    const { gl, at } = this;
    gl.useProgram(this.program);
    if (this.data.uniforms) return this.#setOwn(this.data.uniforms, frame, width, height);
    gl.uniform3f(at('iResolution'), width, height, 1);
    gl.uniform1f(at('iTime'), frame.time);
    gl.uniform1f(at('iTimeDelta'), frame.delta);
    gl.uniform1f(at('iFrameRate'), frame.rate);
    gl.uniform1i(at('iFrame'), frame.number);
    gl.uniform4fv(at('iMouse'), frame.mouse);
    gl.uniform4fv(at('iDate'), frame.date);
  }

  /**
   * Sets the uniforms of a shader that brings its own.
   * @param {OwnUniform[]} uniforms
   * @param {Frame} frame
   * @param {number} width @param {number} height
   */
  #setOwn(uniforms, frame, width, height) {
    const { gl, at } = this;
    /** @type {Record<string, number[]>} */
    const values = {
      iResolution: [width, height, 1],
      iTime: [frame.time],
      iTimeDelta: [frame.delta],
      iFrameRate: [frame.rate],
      iSampleRate: [44100],
      iMouse: frame.mouse,
      iDate: frame.date,
    };
    for (const { name, means, size } of uniforms) {
      const value = values[means].slice(0, size);
      if (size === 1) gl.uniform1fv(at(name), value);
      else if (size === 2) gl.uniform2fv(at(name), value);
      else if (size === 3) gl.uniform3fv(at(name), value);
      else gl.uniform4fv(at(name), value);
    }
    gl.uniform1i(at('iFrame'), frame.number);
  }

  /**
   * Sets what the channels read.
   * @param {{size: number[], time: number, isLoaded: boolean}[]} channels
   */
  setChannels(channels) {
    const { gl, at } = this;
    gl.uniform1fv(at('iChannelTime'), channels.map((c) => c.time));
    gl.uniform3fv(at('iChannelResolution'), channels.flatMap((c) => c.size));
    channels.forEach((channel, i) => {
      gl.uniform3fv(at(`iCh${i}.size`), channel.size);
      gl.uniform1f(at(`iCh${i}.time`), channel.time);
      gl.uniform1i(at(`iCh${i}.loaded`), channel.isLoaded ? 1 : 0);
    });
  }

  /** @param {number[]} corners four directions, then the eye */
  setFace(corners) {
    this.gl.uniform3fv(this.at('unCorners'), [...corners, 0, 0, 0]);
    this.gl.uniform4f(this.at('unViewport'), 0, 0, CUBE_SIZE, CUBE_SIZE);
  }

  /** @param {number} offset first sample of the block */
  setBlock(offset) {
    this.gl.useProgram(this.program);
    this.gl.uniform1f(this.at('iTimeOffset'), offset / SOUND_RATE);
    this.gl.uniform1i(this.at('iSampleOffset'), offset);
  }

  dispose() {
    this.gl.deleteProgram(this.program);
  }
}

/**
 * What a frame is drawn for.
 * @typedef {object} Frame
 * @property {number} number
 * @property {number} time seconds
 * @property {number} delta seconds since the frame before
 * @property {number} rate frames a second
 * @property {number[]} mouse
 * @property {number[]} date
 */

/** Year, month from 0, day, and seconds since midnight. */
function dateUniform() {
  const now = new Date();
  const seconds = now.getHours() * 3600 + now.getMinutes() * 60 + now.getSeconds();
  return [now.getFullYear(), now.getMonth(), now.getDate(), seconds + now.getMilliseconds() / 1000];
}

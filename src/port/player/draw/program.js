// A compiled pass: its program and uniform locations.

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
    data.inputs.forEach((input, channel) => {
      gl.uniform1i(this.at(input?.uniform ?? `iChannel${channel}`), channel);
      gl.uniform1i(this.at(`iCh${channel}.sampler`), channel);
    });
    if (!data.uniforms) gl.uniform1f(this.at('iSampleRate'), SOUND_RATE);
  }

  /**
   * Sets the uniforms of a frame.
   * @param {Frame} frame
   * @param {number} width @param {number} height
   */
  setFrame(frame, width, height) {
    const { gl, at } = this;
    gl.useProgram(this.program);
    if (this.data.uniforms) return parts.setOwnUniforms?.(this, this.data.uniforms, frame, width, height);
    gl.uniform3f(at('iResolution'), width, height, 1);
    gl.uniform1f(at('iTime'), frame.time);
    gl.uniform1f(at('iTimeDelta'), frame.delta);
    gl.uniform1f(at('iFrameRate'), frame.rate);
    gl.uniform1i(at('iFrame'), frame.number);
    gl.uniform4fv(at('iMouse'), frame.mouse);
    gl.uniform4fv(at('iDate'), frame.date);
  }

  /**
   * Sets the uniforms of the channels.
   * @param {{size: number[], time: number, isLoaded: boolean}[]} channels
   */
  setChannels(channels) {
    const { gl, at } = this;
    if (this.data.uniforms) parts.setOwnSizes?.(this, this.data.uniforms, channels);
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

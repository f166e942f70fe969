// Draws all passes of a project in ShaderToy's order. Everything here belongs to one WebGL context; when that
// is lost or given back, the player makes another renderer.

/** The texture unit for everything except channels, which use the units before it. */
const SPARE_UNIT = 16;
/** Pass index of a buffer that is read but never drawn. It stays empty. */
const UNDRAWN = -1;
const CUBE_SIZE = 1024;

/** Whether a channel reads a pass with mipmaps. @param {ProjectData} project @param {number} pass index */
function hasMipmaps(project, pass) {
  const isCube = project.passes[pass]?.kind === 'cubemap';
  /** @param {InputData} input */
  const reads = ({ kind, buffer = UNDRAWN }) =>
    isCube ? kind === 'cubebuffer' : kind === 'buffer' && buffer === pass;
  return project.passes.some((p) => p.inputs.some((i) => i?.filter === 'mipmap' && reads(i)));
}

/**
 * What outlives a context.
 * @typedef {object} RendererState
 * @property {ProjectData} project
 * @property {Map<string, number[]>} controls
 * @property {Devices | null} devices
 * @property {Keyboard | null} keyboard
 * @property {(text: string) => void} complain reports an error that is not in a shader
 */

/** The texels of all buffers, by pass. @typedef {{buffers: Map<number, ReturnType<Buffer['save']>>, cube: Float32Array<ArrayBuffer>[] | null}} SavedTargets */

class Renderer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {RendererState} state
   */
  constructor(gl, state) {
    this.gl = gl;
    this.state = state;
    this.project = state.project;
    gl.activeTexture(gl.TEXTURE0 + SPARE_UNIT);
    this.canDrawFloats = gl.getExtension('EXT_color_buffer_float') !== null;
    gl.getExtension('OES_texture_float_linear');
    const triangle = [-1, -1, 3, -1, -1, 3];
    const corners = [-1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1, 1];
    this.attributes = [fillAttribute(gl, 0, 2, new Float32Array([...triangle, ...corners]))];
    if (parts.numberVertices) this.attributes.push(parts.numberVertices(gl));
    gl.disable(gl.DITHER);
    this.compiled = new Programs(gl, this.project);
    this.keys = state.keyboard?.texture(gl) ?? null;
    this.samplers = samplerCache(gl);
    this.black = blackTextures(gl);
    this.standIns = parts.standIns?.(gl, this.project) ?? null;
    /** @type {Map<number, Buffer>} by pass */
    this.buffers = new Map();
    /** @type {CubeBuffer | null} */
    this.cube = null;
    /** @type {Input[][]} by pass and channel; empty for other passes and the keyboard */
    this.inputs = this.project.passes.map((pass) => pass.inputs.map((data) => this.openInput(data)));
    this.#makeTargets();
  }

  /** @param {InputData | null} data */
  openInput(data) {
    const open = data && (data.standIn && !data.urls && data.kind !== 'music' ? openers.standIn : openers[data.kind]);
    if (!data || !open) return emptyInput();
    return open(this.gl, data, { devices: this.state.devices, standIns: this.standIns });
  }

  /** Waits for the inputs. Failures are reported. */
  async load() {
    const loads = this.inputs.flat().map((input) => input.ready);
    const results = await Promise.allSettled(loads);
    for (const result of results) {
      if (result.status === 'rejected') this.state.complain(`cannot load an input: ${result.reason}`);
    }
  }

  #makeTargets() {
    const { gl, project } = this;
    const readsUndrawn = project.passes.some((p) => p.inputs.some((i) => i?.kind === 'buffer' && i.buffer === undefined));
    const { Buffer: Target, CubeBuffer: CubeTarget } = parts;
    if (readsUndrawn && Target) this.buffers.set(UNDRAWN, new Target(gl, ...this.#passSize(UNDRAWN), false));
    project.passes.forEach((pass, i) => {
      const isRead = project.passes.some((p) => p.inputs.some((input) => input?.kind === 'buffer' && input.buffer === i));
      if (Target && (pass.kind === 'buffer' || (pass.kind === 'image' && isRead))) {
        const first = this.#drawnInto(i);
        const isFloat = pass.float || !pass.uniforms;
        this.buffers.set(i, this.buffers.get(first) ?? new Target(gl, ...this.#passSize(i), isFloat));
      } else if (CubeTarget && pass.kind === 'cubemap') {
        this.cube = new CubeTarget(gl);
      }
    });
    const needsFloats = [...this.buffers.values()].some((b) => b.isFloat) || this.cube !== null;
    if (needsFloats && !this.canDrawFloats) {
      this.state.complain('this device cannot render to float textures, which buffers require');
    }
  }

  /** Adapts the buffers to the size of the canvas. */
  resize() {
    this.buffers.forEach((buffer, i) => buffer.resize(...this.#passSize(i), hasMipmaps(this.project, i)));
  }

  /** The first pass that draws into the same buffer. @param {number} pass index */
  #drawnInto(pass) {
    const { into } = this.project.passes[pass];
    return into ? this.project.passes.findIndex((p) => p.into === into) : pass;
  }

  /** Width and height of the target of a pass. @param {number} pass index @returns {[number, number]} */
  #passSize(pass) {
    const { drawingBufferWidth: width, drawingBufferHeight: height } = this.gl;
    const size = this.project.passes[pass]?.size;
    return (size && parts.ownSize?.(size, width, height, this.state.controls)) ?? [width, height];
  }

  /** Draws all passes. @param {Frame} frame */
  draw(frame) {
    if (frame.number === 0) this.#clear();
    this.keys?.upload();
    this.inputs.flat().forEach((input) => input.update(frame.time));
    for (const kind of ['buffer', 'cubemap', 'image']) {
      this.project.passes.forEach((pass, i) => {
        if (pass.kind === kind) this.#drawPass(i, frame);
      });
    }
  }

  #clear() {
    this.buffers.forEach((buffer, i) => buffer.clear(hasMipmaps(this.project, i)));
    this.cube?.clear(this.#hasCubeMipmaps());
  }

  #hasCubeMipmaps() {
    return hasMipmaps(this.project, this.project.passes.findIndex((p) => p.kind === 'cubemap'));
  }

  /** @param {number} index @param {Frame} frame */
  #drawPass(index, frame) {
    const { gl } = this;
    const program = this.compiled.list[index];
    if (!program) return;
    const withMipmaps = hasMipmaps(this.project, index);
    if (program.data.kind === 'cubemap') {
      this.#bindPass(index, program, frame, CUBE_SIZE, CUBE_SIZE);
      this.cube?.draw(program);
      this.cube?.flip(withMipmaps);
      return;
    }
    const [width, height] = this.#passSize(index);
    const buffer = this.buffers.get(index);
    buffer?.resize(width, height, withMipmaps);
    this.#bindPass(index, program, frame, width, height);
    if (buffer) {
      buffer.bind();
    } else {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(0, 0, width, height);
    }
    if (program.data.fragment) parts.drawVertices?.(gl, this.state.controls);
    else gl.drawArrays(gl.TRIANGLES, program.data.quad ? 3 : 0, program.data.quad ? 6 : 3);
    if (program.data.kind === 'image') buffer?.show();
    buffer?.flip(withMipmaps);
  }

  /**
   * @param {number} index
   * @param {PassProgram} program
   * @param {Frame} frame
   * @param {number} width @param {number} height
   */
  #bindPass(index, program, frame, width, height) {
    program.setFrame(frame, width, height);
    this.#bindChannels(index, program);
  }

  /** @param {number} index of the pass @param {PassProgram} program */
  #bindChannels(index, program) {
    const channels = program.data.inputs.map((_, channel) => this.#bindChannel(index, channel));
    program.setChannels(channels);
  }

  /** Binds the input of a channel. Returns its uniform values. @param {number} pass @param {number} channel */
  #bindChannel(pass, channel) {
    const { gl } = this;
    const data = this.project.passes[pass].inputs[channel];
    const read = this.#read(pass, channel);
    const isCube = data?.kind === 'cubemap' || data?.kind === 'cubebuffer';
    const target = isCube ? gl.TEXTURE_CUBE_MAP : data?.kind === 'volume' ? gl.TEXTURE_3D : gl.TEXTURE_2D;
    gl.activeTexture(gl.TEXTURE0 + channel);
    if (data?.sampler) this.black.bind(data.sampler);
    else gl.bindTexture(target, read.texture ?? this.black.of(target));
    const own = read.texture && data && data.kind !== 'keyboard';
    const sampler = own ? this.samplers.get(data.filter, data.wrap) : this.samplers.get('nearest', 'clamp');
    gl.bindSampler(channel, data?.sampler ? null : sampler);
    gl.activeTexture(gl.TEXTURE0 + SPARE_UNIT);
    return read;
  }

  /** The current input of a channel. @param {number} pass @param {number} channel */
  #read(pass, channel) {
    const data = this.project.passes[pass].inputs[channel];
    const none = { texture: null, size: [0, 0, 0], time: 0, isLoaded: false };
    const isSound = this.project.passes[pass].kind === 'sound';
    if (isSound && data?.kind !== 'texture' && data?.kind !== 'volume') return none;
    if (data?.kind === 'keyboard') {
      const size = this.project.passes[pass].kind === 'cubemap' ? [0, 0, 0] : [256, 3, 1];
      return { texture: this.keys?.texture ?? null, size, time: 0, isLoaded: true };
    }
    if (data?.kind === 'buffer') {
      const buffer = this.buffers.get(data.buffer ?? UNDRAWN);
      if (!buffer) return none;
      const size = [buffer.width, buffer.height, 1];
      return { texture: buffer.texture, size, time: 0, isLoaded: true };
    }
    if (data?.kind === 'cubebuffer') {
      if (!this.cube) return none;
      return { texture: this.cube.texture, size: [CUBE_SIZE, CUBE_SIZE, 1], time: 0, isLoaded: true };
    }
    return this.inputs[pass]?.[channel] ?? none;
  }

  /**
   * Draws a block of the sound pass into the bound framebuffer.
   * @param {number} index
   * @param {number} offset first sample of the block
   */
  drawSound(index, offset) {
    const program = this.compiled.list[index];
    if (!program) return;
    program.setBlock(offset);
    this.#bindChannels(index, program);
    const date = dateUniform();
    this.gl.uniform4f(program.at('iDate'), date[0], date[1], date[2], Math.floor(date[3]));
    this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
  }

  /** What frames to come depend on. @returns {SavedTargets} */
  save() {
    const feeds = this.project.passes.some((p) => p.kind !== 'image' && p.inputs.some((i) => i?.kind === 'cubebuffer'));
    return {
      buffers: new Map([...this.buffers].map(([pass, buffer]) => [pass, buffer.save()])),
      cube: (feeds && this.cube?.save()) || null,
    };
  }

  /** @param {SavedTargets} saved */
  restore(saved) {
    saved.buffers.forEach((texels, pass) => this.buffers.get(pass)?.restore(texels, hasMipmaps(this.project, pass)));
    if (saved.cube) this.cube?.restore(saved.cube, this.#hasCubeMipmaps());
  }

  dispose() {
    const { gl } = this;
    this.inputs.flat().forEach((input) => input.dispose());
    this.compiled.dispose();
    new Set(this.buffers.values()).forEach((b) => b.dispose());
    this.cube?.dispose();
    this.keys?.dispose();
    this.black.dispose();
    this.samplers.dispose();
    this.standIns?.dispose();
    this.attributes.forEach((buffer, i) => {
      gl.disableVertexAttribArray(i);
      gl.deleteBuffer(buffer);
    });
    // Another player may open this context.
    gl.useProgram(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.activeTexture(gl.TEXTURE0);
    gl.enable(gl.DITHER);
  }
}

// The player: draws all passes of a project in ShaderToy's order, with ShaderToy's uniforms.

/** The texture unit for everything except channels, which use the units before it. */
const SPARE_UNIT = 16;

class Player {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {ProjectData} project
   */
  constructor(canvas, project) {
    const hasVertices = project.passes.some((p) => p.fragment);
    const gl = canvas.getContext('webgl2', {
      alpha: false,
      antialias: hasVertices,
      depth: hasVertices,
      stencil: false,
      preserveDrawingBuffer: true,
      powerPreference: 'high-performance',
    });
    if (!gl) throw new Error('WebGL2 is not available in this browser');
    this.canvas = canvas;
    this.gl = gl;
    this.project = project;
    this.devices = new Devices();
    this.mouse = new Mouse();
    /** @type {ShaderError[]} */
    this.errors = [];
    this.clock = new Clock();
    this.isPlaying = false;
    this.isSoundOn = false;
    this.isDisposed = false;
    /** @type {(() => void)[]} called when the visible state changes */
    this.listeners = [];
    /** @type {Input[][]} by pass and channel; empty for other passes and the keyboard */
    this.inputs = [];
    /** @type {Map<number, Buffer>} by pass */
    this.buffers = new Map();
    /** Values set by the user, by uniform. */
    this.controls = new Map(project.controls.map((c) => [c.name, c.value]));
    /** Whether a uniform depends on the mouse position. */
    this.followsPointer = project.passes.some((p) => p.uniforms?.some((u) => u.source.startsWith('pointer')));
    /** @type {CubeBuffer | null} */
    this.cube = null;
    /** @type {Sound | null} */
    this.sound = null;
    this.compiled = this.#openContext();
    this.keyboard = new Keyboard(gl);
    this.samplers = samplerCache(gl);
    this.black = blackTextures(gl);
    this.standIns = standInCache(gl, project);
    this.ready = this.#load();
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => void this.#reopen());
  }

  /** Creates everything that belongs to the WebGL context. */
  #openContext() {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + SPARE_UNIT);
    this.canDrawFloats = gl.getExtension('EXT_color_buffer_float') !== null;
    gl.getExtension('OES_texture_float_linear');
    const triangle = [-1, -1, 3, -1, -1, 3];
    const corners = [-1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1, 1];
    fillAttribute(gl, 0, 2, new Float32Array([...triangle, ...corners]));
    if (this.project.passes.some((p) => p.fragment)) {
      fillAttribute(gl, 1, 1, Float32Array.from({ length: MAX_VERTICES }, (_, i) => i));
    }
    gl.disable(gl.DITHER);
    return new Programs(gl, this.project);
  }

  async #reopen() {
    if (this.isDisposed) return;
    this.compiled.dispose();
    this.buffers.clear();
    this.cube = null;
    this.sound = null;
    this.compiled = this.#openContext();
    this.keyboard = new Keyboard(this.gl);
    this.samplers = samplerCache(this.gl);
    this.black = blackTextures(this.gl);
    this.standIns = standInCache(this.gl, this.project);
    this.ready = this.#load();
    await this.ready;
    this.restart();
  }

  async #load() {
    this.inputs = this.project.passes.map((pass) =>
      pass.inputs.map((data) => (data ? openInput(this.gl, data, this.devices, this.standIns) : emptyInput())),
    );
    this.#makeTargets();
    await this.compile();
    const loads = this.inputs.flat().map((input) => input.ready);
    const results = await Promise.allSettled(loads);
    for (const result of results) {
      if (result.status === 'rejected') this.#complain(`cannot load an input: ${result.reason}`);
    }
    if (this.isPlaying) this.inputs.flat().forEach((input) => input.play(true));
    this.#changed();
  }

  #makeTargets() {
    const { gl, project } = this;
    const readsUndrawn = project.passes.some((p) => p.inputs.some((i) => i?.kind === 'buffer' && i.buffer === undefined));
    if (readsUndrawn) this.buffers.set(UNDRAWN, new Buffer(gl, ...this.#passSize(UNDRAWN), false));
    project.passes.forEach((pass, i) => {
      const isRead = project.passes.some((p) => p.inputs.some((input) => input?.kind === 'buffer' && input.buffer === i));
      if (pass.kind === 'buffer' || (pass.kind === 'image' && isRead)) {
        const first = this.#drawnInto(i);
        const isFloat = pass.float || !pass.uniforms;
        this.buffers.set(i, this.buffers.get(first) ?? new Buffer(gl, ...this.#passSize(i), isFloat));
      } else if (pass.kind === 'cubemap') {
        this.cube = new CubeBuffer(gl);
      }
    });
    const needsFloats = [...this.buffers.values()].some((b) => b.isFloat) || this.cube !== null;
    if (needsFloats && !this.canDrawFloats) {
      this.#complain('this device cannot render to float textures, which buffers require');
    }
  }

  /** Compiles changed passes. Failures are listed in `errors`. */
  async compile() {
    const { compiled } = this;
    const sound = this.#soundProgram();
    await compiled.compile();
    if (compiled !== this.compiled || this.isDisposed) return;
    this.errors = this.errors.filter((e) => e.line < 0).concat(compiled.errors);
    if (sound && sound !== this.#soundProgram()) this.#forgetSound();
    this.#changed();
  }

  /** Adds an error that is not in a shader; its line is -1. @param {string} text */
  #complain(text) {
    this.errors.push({ pass: '', line: -1, text });
    this.#changed();
  }

  #changed() {
    this.listeners.forEach((listener) => listener());
  }

  /** @param {number} width @param {number} height pixels */
  resize(width, height) {
    const [w, h] = [Math.max(1, Math.round(width)), Math.max(1, Math.round(height))];
    if (this.canvas.width === w && this.canvas.height === h) return;
    this.canvas.width = w;
    this.canvas.height = h;
    this.buffers.forEach((buffer, i) => buffer.resize(...this.#passSize(i), hasMipmaps(this.project, i)));
    if (!this.isPlaying && this.programs.some(Boolean)) this.paint(this.clock.frozen());
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
    if (!size) return [width, height];
    /** @type {Record<string, number>} */
    const canvas = { $WIDTH: width, $HEIGHT: height };
    const valueOf = (/** @type {string} */ name) => canvas[name] ?? this.controls.get(name)?.[0] ?? 0;
    return [pixels(sizeOf(size[0], valueOf)), pixels(sizeOf(size[1], valueOf))];
  }

  /** Draws one frame. @param {{number: number, time: number, delta: number, rate: number}} tick */
  paint(tick) {
    if (this.isDisposed || this.gl.isContextLost()) return;
    const { mouse, controls } = this;
    const frame = { ...tick, mouse: mouse.value(), pointer: mouse.pointer(), date: dateUniform(), controls };
    if (frame.number === 0) this.#clear();
    this.keyboard.upload();
    this.inputs.flat().forEach((input) => input.update(frame.time));
    for (const kind of ['buffer', 'cubemap', 'image']) {
      this.project.passes.forEach((pass, i) => {
        if (pass.kind === kind) this.#drawPass(i, frame);
      });
    }
    this.keyboard.endFrame();
    this.mouse.endFrame();
  }

  #clear() {
    this.buffers.forEach((buffer, i) => buffer.clear(hasMipmaps(this.project, i)));
    const cubePass = this.project.passes.findIndex((p) => p.kind === 'cubemap');
    this.cube?.clear(hasMipmaps(this.project, cubePass));
  }

  /** @param {number} index @param {Frame} frame */
  #drawPass(index, frame) {
    const { gl } = this;
    const program = this.programs[index];
    if (!program) return;
    const withMipmaps = hasMipmaps(this.project, index);
    if (program.data.kind === 'cubemap') {
      this.#bindPass(index, program, frame, CUBE_SIZE, CUBE_SIZE);
      CUBE_CORNERS.forEach((corners, face) => {
        this.cube?.bind(face);
        program.setFace(corners);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      });
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
    if (program.data.fragment) drawVertices(gl, this.controls);
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
    const black = isCube ? this.black.cube : data?.kind === 'volume' ? this.black.volume : this.black.flat;
    gl.activeTexture(gl.TEXTURE0 + channel);
    if (data?.sampler) this.black.bind(data.sampler);
    else gl.bindTexture(target, read.texture ?? black);
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
      return { texture: this.keyboard.texture, size, time: 0, isLoaded: true };
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

  play() {
    if (this.isPlaying || this.isDisposed) return;
    this.isPlaying = true;
    this.clock.resume();
    this.inputs.flat().forEach((input) => input.play(true));
    this.#playSound();
    const loop = () => {
      if (!this.isPlaying) return;
      this.paint(this.clock.tick());
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
    this.#changed();
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.clock.pause();
    this.inputs.flat().forEach((input) => input.play(false));
    this.sound?.stop();
    this.#changed();
  }

  /** Restarts at time 0. Keys and the mouse keep their state. */
  restart() {
    this.clock.reset();
    this.inputs.flat().forEach((input) => input.rewind());
    this.#playSound();
    if (!this.isPlaying) this.paint(this.clock.frozen());
    this.#changed();
  }

  /** Seeks to a time in seconds and draws a frame. @param {number} time */
  seek(time) {
    this.clock.seek(time);
    this.#playSound();
    if (!this.isPlaying) this.paint(this.clock.frozen());
    this.#changed();
  }

  /**
   * Restarts and draws the frames 0 to `last`, at 60 frames per second. Resolves when the last one is on
   * the canvas.
   * @param {number} last
   */
  async renderFrame(last) {
    await this.ready;
    this.pause();
    this.clock.reset();
    this.inputs.flat().forEach((input) => input.rewind());
    for (let number = 0; number <= last; number++) this.paint(this.clock.step());
    this.gl.finish();
    this.#changed();
  }

  /** Pauses and draws the next frame at 60 frames per second. */
  step() {
    this.pause();
    this.clock.time += FIRST_DELTA;
    this.paint(this.clock.frozen());
    this.#changed();
  }

  /** Draws a frame while paused, after a change of the input. */
  poke() {
    if (!this.isPlaying) this.paint(this.clock.frozen());
  }

  /** @param {number} x @param {number} y pixels from the lower left corner @param {boolean} isDown */
  setMouse(x, y, isDown) {
    if (isDown && !this.mouse.isDown) this.mouse.press(x, y);
    else if (isDown) this.mouse.move(x, y);
    else this.mouse.release();
  }

  /** @param {number} code the keyCode of JavaScript @param {boolean} isDown */
  setKey(code, isDown) {
    this.keyboard.set(code, isDown);
  }

  /** @returns {(PassProgram | null)[]} by pass */
  get programs() {
    return this.compiled.list;
  }

  get hasSound() {
    return this.project.passes.some((p) => p.kind === 'sound' || p.inputs.some((i) => i?.kind === 'music'));
  }

  /** @param {boolean} isOn */
  setSound(isOn) {
    if (this.isDisposed) return;
    this.isSoundOn = isOn;
    this.devices.setAudible(isOn);
    this.#playSound();
    this.#changed();
  }

  #soundProgram() {
    return this.programs[this.project.passes.findIndex((p) => p.kind === 'sound')];
  }

  #playSound() {
    const index = this.project.passes.findIndex((p) => p.kind === 'sound');
    const program = this.#soundProgram();
    if (!program) return;
    if (!this.isSoundOn || !this.isPlaying || this.isDisposed) return this.sound?.stop();
    this.sound ??= new Sound(this.gl, (offset) => this.drawSound(index, program, offset));
    void this.sound.play(this.devices, this.clock.time);
  }

  /** The left and right samples of the sound pass; null without one. */
  async samples() {
    const index = this.project.passes.findIndex((p) => p.kind === 'sound');
    const program = this.#soundProgram();
    if (!program) return null;
    this.sound ??= new Sound(this.gl, (offset) => this.drawSound(index, program, offset));
    await this.sound.finish();
    return [this.sound.left, this.sound.right];
  }

  /** Discards the computed sound after the sound pass has changed. */
  #forgetSound() {
    this.sound?.dispose();
    this.sound = null;
    this.#playSound();
  }

  /**
   * Draws a block of the sound pass into the bound framebuffer.
   * @param {number} index
   * @param {PassProgram} program
   * @param {number} offset
   */
  drawSound(index, program, offset) {
    program.setBlock(offset);
    const channels = program.data.inputs.map((_, channel) => this.#bindChannel(index, channel));
    program.setChannels(channels);
    const date = dateUniform();
    this.gl.uniform4f(program.at('iDate'), date[0], date[1], date[2], Math.floor(date[3]));
    this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
  }

  /**
   * Sets the file of a channel.
   * @param {number} pass @param {number} channel @param {string} name @param {string} url
   * @param {string} [kind] the kind of the file, if it differs from the previous input
   */
  async setInput(pass, channel, name, url, kind) {
    if (this.isDisposed) return;
    const inputs = this.project.passes[pass].inputs;
    const old = inputs[channel] ?? { kind: 'texture', filter: 'mipmap', wrap: 'repeat', vflip: true };
    const data = { ...old, kind: kind ?? old.kind, name, urls: old.kind === 'cubemap' ? Array(6).fill(url) : [url] };
    const input = openInput(this.gl, data, this.devices, this.standIns);
    await input.ready;
    this.inputs[pass][channel].dispose();
    this.inputs[pass][channel] = input;
    inputs[channel] = data;
    if (this.isPlaying) input.play(true);
    this.poke();
    this.#changed();
  }

  /** Sets the value of a control. @param {string} name @param {number[]} numbers */
  setControl(name, numbers) {
    const control = this.project.controls.find((c) => c.name === name);
    if (!control || !numbers.every(Number.isFinite)) return;
    control.value = control.value.map((old, i) => numbers[i] ?? old);
    this.controls.set(name, control.value);
    this.poke();
  }

  /**
   * Sets a tunable number, within the limits of its author, and recompiles.
   * @param {string} name @param {number} value
   */
  async setTunable(name, value) {
    const all = this.project.tunables.filter((t) => t.name === name);
    if (all.length === 0) throw new RangeError(`unknown tunable: ${name}`);
    if (typeof value !== 'number' || Number.isNaN(value)) throw new TypeError(`${name} must be a number`);
    for (const tunable of all) setNumber(this.project, tunable, value);
    await this.compile();
    this.poke();
  }

  /**
   * Replaces one of the user's texts and recompiles the passes that contain it.
   * @param {number} file @param {string} text
   */
  async setCode(file, text) {
    changeText(this.project, file, text);
    await this.compile();
    this.poke();
  }

  dispose() {
    this.pause();
    this.isDisposed = true;
    this.clock.dispose();
    this.inputs.flat().forEach((input) => input.dispose());
    this.compiled.dispose();
    this.buffers.forEach((b) => b.dispose());
    this.cube?.dispose();
    this.sound?.dispose();
    this.samplers.dispose();
    this.standIns.dispose();
    this.devices.dispose();
  }
}

// The player: time, input and sound of a project, and the renderer while there is a context.

/** Maximum width and height of the canvas, and its maximum number of pixels. */
const MAX_CANVAS = 8192;
const MAX_PIXELS = 2 ** 25;

class Player {
  /** @type {(value?: void) => void} */
  #isReady = () => {};
  /** @type {(reason: unknown) => void} */
  #hasFailed = () => {};
  /** What the renderer of the given back context left. @type {SavedTargets | null} */
  #saved = null;
  /** Errors that are not in a shader. @type {ShaderError[]} */
  #complaints = [];
  #isLooping = false;
  /** Whether there was a context before. */
  #isReopened = false;
  #end = new AbortController();

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {ProjectData} project
   */
  constructor(canvas, project) {
    if (typeof WebGL2RenderingContext === 'undefined') throw new Error(NO_WEBGL2);
    this.canvas = canvas;
    this.project = project;
    this.devices = parts.Devices ? new parts.Devices() : null;
    this.keyboard = parts.Keyboard ? new parts.Keyboard() : null;
    this.mouse = new Mouse();
    this.clock = new Clock();
    this.isPlaying = false;
    this.isSoundOn = false;
    this.isDisposed = false;
    /** Whether the canvas can be seen; a player that is not seen stands still. */
    this.isSeen = true;
    /** @type {(() => void)[]} called when the visible state changes */
    this.listeners = [];
    /** Values set by the user, by uniform. */
    this.controls = new Map(project.controls.map((c) => [c.name, c.value]));
    /** Whether a uniform depends on the mouse position. */
    this.followsPointer = project.passes.some((p) => p.uniforms?.some((u) => u.source.startsWith('pointer')));
    /** @type {Sound | null} */
    this.sound = null;
    /** @type {Renderer | null} null without a context */
    this.renderer = null;
    this.context = new ContextHolder(canvas, project, this.#end.signal, {
      opened: (gl) => this.#opened(gl),
      lost: () => this.#lost(),
    });
    /** Resolves when all passes are compiled and all inputs are loaded, for the first time. @type {Promise<void>} */
    this.ready = new Promise((resolve, reject) => {
      this.#isReady = resolve;
      this.#hasFailed = reject;
    });
    this.ready.catch(() => {});
  }

  /** Opens the context if there is none. Returns `ready`. */
  open() {
    if (this.isDisposed || this.renderer) return this.ready;
    try {
      this.context.open();
    } catch (error) {
      this.#hasFailed(error);
    }
    return this.ready;
  }

  /** Gives the context back, as browsers have few. The canvas shows its last image until `open`. */
  rest() {
    if (this.renderer) this.#saved = this.renderer.save();
    this.context.giveBack();
  }

  /** @param {WebGL2RenderingContext} gl */
  #opened(gl) {
    const { project, controls, devices, keyboard } = this;
    const complain = (/** @type {string} */ text) => this.#complain(text);
    this.#complaints = [];
    const renderer = new Renderer(gl, { project, controls, devices, keyboard, complain });
    this.renderer = renderer;
    void this.#load(renderer);
  }

  #lost() {
    this.sound?.dispose();
    this.sound = null;
    this.renderer = null;
    this.#changed();
  }

  /** @param {Renderer} renderer */
  async #load(renderer) {
    await this.compile();
    await renderer.load();
    if (renderer !== this.renderer || this.isDisposed) return;
    const saved = this.#saved;
    this.#saved = null;
    if (saved) renderer.restore(saved);
    // What earlier frames left is lost with a context that was not given back.
    else if (renderer.buffers.size > 0 || renderer.cube) this.clock.reset();
    this.#playInputs();
    this.#playSound();
    if (this.#isReopened) this.poke();
    this.#isReopened = true;
    this.#isReady();
    this.#loop();
    this.#changed();
  }

  /** Compiles changed passes. Failures are listed in `errors`. */
  async compile() {
    const { renderer } = this;
    const sound = this.#soundProgram();
    await renderer?.compiled.compile();
    if (renderer !== this.renderer || this.isDisposed) return;
    if (sound && sound !== this.#soundProgram()) this.#forgetSound();
    this.#changed();
  }

  /** Errors of shaders, and with line -1 others. */
  get errors() {
    return this.#complaints.concat(this.renderer?.compiled.errors ?? []);
  }

  /** @param {string} text */
  #complain(text) {
    this.#complaints.push({ pass: '', line: -1, text });
    this.#changed();
  }

  #changed() {
    this.listeners.forEach((listener) => listener());
  }

  /** @param {number} width @param {number} height pixels; both are reduced if they are too many */
  resize(width, height) {
    const [most, area] = [Math.max(width, height, 1), Math.max(width * height, 1)];
    const factor = Math.min(1, MAX_CANVAS / most, Math.sqrt(MAX_PIXELS / area));
    const [w, h] = [width, height].map((side) => Math.max(1, Math.round(side * factor) || 1));
    if (this.canvas.width === w && this.canvas.height === h) return;
    this.canvas.width = w;
    this.canvas.height = h;
    this.renderer?.resize();
    if (!this.isPlaying && this.programs.some(Boolean)) this.paint(this.clock.frozen());
  }

  /** Draws one frame. @param {{number: number, time: number, delta: number, rate: number}} tick */
  paint(tick) {
    if (this.isDisposed || !this.renderer || this.context.isLost) return;
    const { mouse, controls } = this;
    const frame = { ...tick, mouse: mouse.value(), pointer: mouse.pointer(), date: dateUniform(), controls };
    this.renderer.draw(frame);
    this.context.drew();
    this.keyboard?.endFrame();
    this.mouse.endFrame();
  }

  play() {
    if (this.isPlaying || this.isDisposed) return;
    this.isPlaying = true;
    this.#run();
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.#run();
  }

  /** Stands still while the canvas cannot be seen. @param {boolean} isSeen */
  setSeen(isSeen) {
    if (isSeen === this.isSeen) return;
    this.isSeen = isSeen;
    if (this.isPlaying) this.#run();
  }

  /** Starts or stops what runs while the player plays and is seen. */
  #run() {
    this.clock.rest();
    this.#playInputs();
    this.#playSound();
    this.#loop();
    this.#changed();
  }

  get #isRunning() {
    return this.isPlaying && this.isSeen && !this.isDisposed;
  }

  #playInputs() {
    this.inputs.flat().forEach((input) => input.play(this.#isRunning));
  }

  #loop() {
    if (this.#isLooping) return;
    const turn = () => {
      this.#isLooping = this.#isRunning && this.renderer !== null;
      if (!this.#isLooping) return;
      this.paint(this.clock.tick());
      requestAnimationFrame(turn);
    };
    this.#isLooping = true;
    requestAnimationFrame(turn);
  }

  /** Restarts at time 0. Keys and the mouse keep their state. */
  restart() {
    this.clock.reset();
    this.inputs.flat().forEach((input) => input.rewind());
    this.#playSound();
    this.poke();
    this.#changed();
  }

  /** Seeks to a time in seconds and draws a frame. @param {number} time */
  seek(time) {
    this.clock.seek(time);
    this.#playSound();
    this.poke();
    this.#changed();
  }

  /**
   * Restarts and draws the frames 0 to `last`, at 60 frames per second. Resolves when the last one is on
   * the canvas.
   * @param {number} last
   */
  async renderFrame(last) {
    await this.open();
    this.pause();
    this.clock.reset();
    this.inputs.flat().forEach((input) => input.rewind());
    for (let number = 0; number <= last; number++) this.paint(this.clock.step());
    this.gl?.finish();
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
    this.keyboard?.set(code, isDown);
  }

  get gl() {
    return this.renderer?.gl ?? null;
  }

  /** @returns {Input[][]} by pass and channel; empty for other passes and the keyboard */
  get inputs() {
    return this.renderer?.inputs ?? [];
  }

  /** @returns {(PassProgram | null)[]} by pass */
  get programs() {
    return this.renderer?.compiled.list ?? [];
  }

  get hasSound() {
    return this.project.passes.some((p) => p.kind === 'sound' || p.inputs.some((i) => i?.kind === 'music'));
  }

  /** @param {boolean} isOn */
  setSound(isOn) {
    if (this.isDisposed) return;
    this.isSoundOn = isOn;
    this.devices?.setAudible(isOn);
    this.#playSound();
    this.#changed();
  }

  #soundProgram() {
    return this.programs[this.project.passes.findIndex((p) => p.kind === 'sound')];
  }

  /** The sound pass; null without one or without a context. */
  #openSound() {
    const { renderer, project } = this;
    const index = project.passes.findIndex((p) => p.kind === 'sound');
    if (!parts.Sound || !renderer || !this.#soundProgram()) return null;
    this.sound ??= new parts.Sound(renderer.gl, (offset) => renderer.drawSound(index, offset));
    return this.sound;
  }

  #playSound() {
    if (!this.isSoundOn || !this.#isRunning) return this.sound?.stop();
    const { devices } = this;
    if (devices) void this.#openSound()?.play(devices, this.clock.time);
  }

  /** The left and right samples of the sound pass; null without one. */
  async samples() {
    await this.open();
    const sound = this.#openSound();
    await sound?.finish();
    return sound && [sound.left, sound.right];
  }

  /** Discards the computed sound after the sound pass has changed. */
  #forgetSound() {
    this.sound?.dispose();
    this.sound = null;
    this.#playSound();
  }

  /**
   * Sets the file of a channel.
   * @param {number} pass @param {number} channel @param {string} name @param {string} url
   * @param {string} [kind] the kind of the file, if it differs from the previous input
   */
  async setInput(pass, channel, name, url, kind) {
    if (this.isDisposed) return;
    await this.open();
    const inputs = this.project.passes[pass].inputs;
    const old = inputs[channel] ?? { kind: 'texture', filter: 'mipmap', wrap: 'repeat', vflip: true };
    const data = { ...old, kind: kind ?? old.kind, name, urls: old.kind === 'cubemap' ? Array(6).fill(url) : [url] };
    const { renderer } = this;
    if (!renderer) return;
    const input = renderer.openInput(data);
    await input.ready;
    renderer.inputs[pass][channel].dispose();
    renderer.inputs[pass][channel] = input;
    inputs[channel] = data;
    if (this.#isRunning) input.play(true);
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
   * Sets a tunable value, within the limits of its author, and recompiles.
   * @param {string} name @param {number | boolean | (number | boolean)[]} value
   */
  async setTunable(name, value) {
    if (!parts.setTunables?.(this.project, name, value)) throw new RangeError(`unknown tunable: ${name}`);
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
    this.#end.abort();
    this.clock.dispose();
    this.sound?.dispose();
    this.renderer?.dispose();
    this.renderer = null;
    this.devices?.dispose();
    this.context.dispose();
  }
}

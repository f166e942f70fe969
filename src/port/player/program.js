// One pass made ready to draw: its program, and where its uniforms lie.

/** How a type of uniform is set, and how many numbers it takes. @type {Record<string, [string, number]>} */
const SETTERS = {
  float: ['1fv', 1], vec2: ['2fv', 2], vec3: ['3fv', 3], vec4: ['4fv', 4],
  int: ['1iv', 1], ivec2: ['2iv', 2], ivec3: ['3iv', 3], ivec4: ['4iv', 4],
  bool: ['1iv', 1], bvec2: ['2iv', 2], bvec3: ['3iv', 3], bvec4: ['4iv', 4],
  uint: ['1uiv', 1], uvec2: ['2uiv', 2], uvec3: ['3uiv', 3], uvec4: ['4uiv', 4],
};

/** What a uniform is given, by its source. @type {Record<string, (f: Frame, w: number, h: number) => number[]>} */
const SOURCES = {
  time: (f) => [f.time],
  milliseconds: (f) => [f.time * 1000],
  delta: (f) => [f.delta],
  frame: (f) => [f.number],
  frameFromOne: (f) => [f.number + 1],
  frameRate: (f) => [f.rate],
  sampleRate: () => [44100],
  date: (f) => f.date,
  dateFromOne: ({ date: [year, month, ...rest] }) => [year, month + 1, ...rest],
  resolution: (_, w, h) => [w, h, 1, 1],
  resolutionAndPixel: (_, w, h) => [w, h, 1 / w, 1 / h],
  pixel: (_, w, h) => [1 / w, 1 / h],
  aspect: (_, w, h) => [w / h],
  pixelRatio: () => [devicePixelRatio],
  surfaceSize: (_, w, h) => [w / h, 1],
  mouse: (f) => f.mouse,
  pointer: ({ pointer: p }) => [p?.x ?? 0, p?.y ?? 0, p?.isDown ? 1 : 0, 0],
  pointerUnit: ({ pointer: p }, w, h) => (p ? [p.x / w, p.y / h] : [0.5, 0.5]),
  pointerUnitDown: ({ pointer: p }, w, h) => (p ? [p.x / w, 1 - p.y / h] : [0.5, 0.5]),
  pointerUnitZero: ({ pointer: p }, w, h) => (p ? [p.x / w, p.y / h] : [0, 0]),
  pointerSigned: ({ pointer: p }, w, h) => (p ? [(2 * p.x) / w - 1, (2 * p.y) / h - 1] : [0, 0]),
  button: ({ pointer: p }) => [p?.isDown ? 1 : 0],
  spectrum: (f) => madeUpSpectrum(f.time),
  volume: (f) => [madeUpSpectrum(f.time)[0]],
  historySize: () => [SIGNAL_WIDTH, HISTORY_ROWS],
  camera: () => [0, 0, 1],
  nothing: () => [],
};

/** How loud low, middle and high sounds are that nobody plays. @param {number} time */
function madeUpSpectrum(time) {
  const beat = Math.pow(0.5 + 0.5 * Math.sin(6.2831 * time), 4);
  return [beat, 0.4 + 0.3 * Math.sin(13 * time) * Math.sin(1.7 * time), 0.2 + 0.15 * Math.sin(23 * time)];
}

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
    this.gl.uniform2f(this.at('port_size'), width, height);
    for (const { name, type, source } of uniforms) {
      if (source === 'identity') this.#setIdentity(name, type);
      else if (source === 'control') this.#set(name, type, frame.controls.get(name) ?? []);
      else this.#set(name, type, SOURCES[source](frame, width, height));
    }
  }

  /** Sets a scalar or vector; lanes without a number are 0. @param {string} name @param {string} type @param {number[]} value */
  #set(name, type, value) {
    const place = this.at(name);
    if (!place || !SETTERS[type]) return;
    const [method, size] = SETTERS[type];
    const gl = /** @type {Record<string, any>} */ (/** @type {unknown} */ (this.gl));
    gl[`uniform${method}`](place, Array.from({ length: size }, (_, i) => value[i] ?? 0));
  }

  /** Sets a matrix to one that changes nothing. @param {string} name @param {string} type mat4, mat2x3 */
  #setIdentity(name, type) {
    const place = this.at(name);
    const [columns, rows = columns] = type.slice(3).split('x').map(Number);
    if (!place) return;
    const numbers = Array.from({ length: columns * rows }, (_, i) => (i % rows === Math.floor(i / rows) ? 1 : 0));
    const gl = /** @type {Record<string, any>} */ (/** @type {unknown} */ (this.gl));
    gl[`uniformMatrix${type.slice(3)}fv`](place, false, numbers);
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
 * @property {{x: number, y: number, isDown: boolean} | null} pointer where the mouse is, if it has come
 * @property {Map<string, number[]>} controls what the user sets
 * @property {number[]} date
 */

/** Year, month from 0, day, and seconds since midnight. */
function dateUniform() {
  const now = new Date();
  const seconds = now.getHours() * 3600 + now.getMinutes() * 60 + now.getSeconds();
  return [now.getFullYear(), now.getMonth(), now.getDate(), seconds + now.getMilliseconds() / 1000];
}

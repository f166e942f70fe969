// Uniform values for shaders that declare their own uniforms. Shared with the module for three.js.

/** By uniform type: the setter and the number of components. @type {Record<string, [string, number]>} */
const SETTERS = {
  float: ['1fv', 1], vec2: ['2fv', 2], vec3: ['3fv', 3], vec4: ['4fv', 4],
  int: ['1iv', 1], ivec2: ['2iv', 2], ivec3: ['3iv', 3], ivec4: ['4iv', 4],
  bool: ['1iv', 1], bvec2: ['2iv', 2], bvec3: ['3iv', 3], bvec4: ['4iv', 4],
  uint: ['1uiv', 1], uvec2: ['2uiv', 2], uvec3: ['3uiv', 3], uvec4: ['4uiv', 4],
};

/** Values of uniforms by source. @type {Record<string, (f: Frame, w: number, h: number) => number[]>} */
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
  volumeBytes: (f) => [255 * madeUpSpectrum(f.time)[0]],
  historySize: () => [SIGNAL_WIDTH, HISTORY_ROWS],
  camera: () => [0, 0, 1],
  width: (_, w) => [w],
  height: (_, _w, h) => [h],
  progress: (f) => [Math.min(f.time % CURSOR_STEP, 1)],
  cursor: (f, w, h) => textCursor(f.time, w, h),
  cursorBefore: (f, w, h) => textCursor(f.time - CURSOR_STEP, w, h),
  cursorTime: (f) => [Math.floor(f.time / CURSOR_STEP) * CURSOR_STEP],
  cursorColor: () => [1, 0.6, 0.2, 1],
  ones: () => [1, 1, 1, 1],
  nothing: () => [],
};

/** Seconds between two moves of the text cursor, and from one animation to the next. */
const CURSOR_STEP = 1.5;

/**
 * The text cursor at a time: its left and upper edge, width and height. It visits the cells of a grid.
 * @param {number} time @param {number} w @param {number} h
 */
function textCursor(time, w, h) {
  const step = Math.floor(time / CURSOR_STEP) + 1;
  return [(((step * 19) % 48) * w) / 48, h - (((step * 5) % 16) * h) / 16, w / 48, h / 16];
}

/** Synthetic levels of low, middle and high frequencies. @param {number} time */
function madeUpSpectrum(time) {
  const beat = Math.pow(0.5 + 0.5 * Math.sin(6.2831 * time), 4);
  return [beat, 0.4 + 0.3 * Math.sin(13 * time) * Math.sin(1.7 * time), 0.2 + 0.15 * Math.sin(23 * time)];
}

/** Extends a value to a number of components with zeros. @param {number} size @param {number[]} value */
function lanesOf(size, value) {
  return Array.from({ length: size }, (_, i) => value[i] ?? 0);
}

/** The identity matrix of a type, column by column. @param {string} type mat4, mat2x3 */
function identityOf(type) {
  const [columns, rows = columns] = type.slice(3).split('x').map(Number);
  return Array.from({ length: columns * rows }, (_, i) => (i % rows === Math.floor(i / rows) ? 1 : 0));
}

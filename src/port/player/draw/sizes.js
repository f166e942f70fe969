// Sizes of targets that depend on the canvas or on controls. Shared with the module for three.js.

/** Functions of size expressions that Math does not have. @type {Record<string, (...n: number[]) => number>} */
const SIZE_FUNCTIONS = {
  add: (a, b) => a + b,
  subtract: (a, b) => a - b,
  multiply: (a, b) => a * b,
  divide: (a, b) => a / b,
  modulo: (a, b) => a % b,
};

/** @param {SizeTerm} term @param {(name: string) => number} valueOf @returns {number} */
function sizeOf(term, valueOf) {
  if (typeof term === 'number') return term;
  if (typeof term === 'string') return valueOf(term);
  const [name, terms] = term;
  const math = /** @type {Record<string, any>} */ (/** @type {unknown} */ (Math));
  return (SIZE_FUNCTIONS[name] ?? math[name])(...terms.map((t) => sizeOf(t, valueOf)));
}

/** Maximum width and height of a buffer with its own size. */
const MAX_SIDE = 8192;

/** Rounds a size to pixels. @param {number} size */
function pixels(size) {
  return Math.min(MAX_SIDE, Math.max(1, Math.floor(size) || 1));
}

// Whether a frame may take so long that the browser stops responding.

/** Operations of a frame that a GPU does in some hundredths of a second, and a processor in about one. */
const MOST = { gpu: 3e9, processor: 1.5e8 };

/** What WebGL draws with: a processor, if the browser has no GPU. */
function renderer() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software/i.test(name) ? 'processor' : 'gpu';
}

let known;

/** A number of operations in words. @param {number} count */
export function inWords(count) {
  const [unit, word] = count >= 1e9 ? [1e9, 'billion'] : [1e6, 'million'];
  return `${(count / unit).toPrecision(2).replace(/\.0$/, '')} ${word}`;
}

/**
 * The operations of a frame, and how much smaller it has to be to be drawn quickly; 1 if it need not be.
 * @param {number} perPixel operations
 * @param {number} pixels of the frame
 */
export function frameCost(perPixel, pixels) {
  known ??= renderer();
  const operations = perPixel * pixels;
  return { operations, divisor: Math.max(1, 2 ** Math.ceil(Math.log2(operations / MOST[known]))) };
}

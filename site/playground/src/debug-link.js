// What follows the code in links that open the debugger:
// `&debug&pixel=160,90&size=320x180&time=1.5&frame=90&pass=buffer_a&mouse=10,20&u.SPEED=2`.

/**
 * What a link debugs. What it does not name is as without a link.
 * @typedef {object} DebugStart
 * @property {number[]} [pixel] from the lower left corner
 * @property {number[]} [size] of the image
 * @property {number} [time] in seconds
 * @property {number} [frame]
 * @property {number[]} [mouse]
 * @property {string} [pass] such as `buffer_a`
 * @property {[string, string][]} uniforms with the prefix `u.`
 */

/** What a link debugs; undefined if it does not. Values that cannot be read are ignored. @param {string} fragment @returns {DebugStart | undefined} */
export function debugStartIn(fragment) {
  const words = new URLSearchParams(fragment.slice(1));
  if (!words.has('debug')) return undefined;
  const numbers = (name, form) => {
    const found = form.exec(words.get(name) ?? '')?.slice(1).map(Number);
    return found?.every(Number.isFinite) ? found : undefined;
  };
  return {
    pixel: numbers('pixel', /^(\d+),(\d+)$/),
    size: numbers('size', /^([1-9]\d{0,3})x([1-9]\d{0,3})$/),
    time: numbers('time', /^(\d[\d.e-]*)$/)?.[0],
    frame: numbers('frame', /^(\d{1,9})$/)?.[0],
    mouse: numbers('mouse', /^(\d+),(\d+)$/),
    pass: words.get('pass') ?? undefined,
    uniforms: [...words].filter(([name]) => name.startsWith('u.')),
  };
}

/** What follows the code in a link to what is debugged. @param {any} launch the arguments of `launch` */
export function debugWords({ pixel, size, time, frame, pass, mouse, uniforms = {} }) {
  const words = [
    'debug',
    `pixel=${pixel}`,
    `size=${size.join('x')}`,
    `time=${time}`,
    `frame=${frame}`,
    ...(pass ? [`pass=${pass}`] : []),
    ...(mouse ? [`mouse=${mouse.x},${mouse.y}`] : []),
    ...Object.entries(uniforms).map(([name, value]) => `u.${name}=${value}`),
  ];
  return words.map((word) => `&${word}`).join('');
}

// State in the URL fragment:
// `#size=320x180&t=2.5&paused&scale=0.5&bar=off&embed&play&u.SPEED=2&u.TINT=1,0.5,0`.

/** Limits of the scale in the URL: larger images would only be slow. */
const MIN_SCALE = 0.05;
const MAX_SCALE = 4;

/** Parses the numbers of a control. @param {string} text */
function readNumbers(text) {
  const numbers = text.split(',').map((word) => (word.trim() ? Number(word) : NaN));
  return numbers.every(Number.isFinite) ? numbers : null;
}

function readAddress() {
  const words = new URLSearchParams(location.hash.slice(1));
  const size = /^(\d{1,4})x(\d{1,4})$/.exec(words.get('size') ?? '');
  const time = readNumbers(words.get('t') ?? '');
  const scale = readNumbers(words.get('scale') ?? '');
  /** @type {Map<string, number[]>} */
  const values = new Map();
  for (const [key, word] of words) {
    const numbers = readNumbers(word);
    if (key.startsWith('u.') && numbers) values.set(key.slice(2), numbers);
  }
  return {
    size: size ? [Number(size[1]), Number(size[2])] : null,
    time: time ? time[0] : null,
    scale: scale && scale[0] > 0 ? Math.min(Math.max(scale[0], MIN_SCALE), MAX_SCALE) : null,
    isPaused: words.has('paused'),
    isOpened: words.has('play'),
    isEmbedded: words.has('embed'),
    hasBar: words.get('bar') !== 'off',
    values,
  };
}

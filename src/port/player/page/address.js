// State in the URL fragment:
// `#size=320x180&t=2.5&paused&scale=0.5&bar=off&embed&play&u.SPEED=2&u.TINT=1,0.5,0`.

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
    scale: scale && scale[0] > 0 ? scale[0] : null,
    isPaused: words.has('paused'),
    isOpened: words.has('play'),
    isEmbedded: words.has('embed'),
    hasBar: words.get('bar') !== 'off' && !words.has('embed'),
    values,
  };
}

/** The fragment with some parameters changed; null removes a parameter. @param {Record<string, string | null>} changes */
function fragmentWith(changes) {
  const words = new Map(new URLSearchParams(location.hash.slice(1)));
  for (const [key, word] of Object.entries(changes)) {
    if (word === null) words.delete(key);
    else words.set(key, word);
  }
  /** @param {string} text */
  const written = (text) => encodeURIComponent(text).replaceAll('%2C', ',');
  return [...words].map(([key, word]) => (word ? `${written(key)}=${written(word)}` : written(key))).join('&');
}

/** @type {Record<string, string | null>} */
let pendingWords = {};
let pendingWrite = 0;

/** Stores parameters in the URL. Browsers limit how often this may happen. @param {Record<string, string | null>} changes */
function keepInAddress(changes) {
  Object.assign(pendingWords, changes);
  clearTimeout(pendingWrite);
  pendingWrite = setTimeout(writeAddress, 250);
}

/** Writes pending parameters immediately. */
function writeAddress() {
  const fragment = fragmentWith(pendingWords);
  pendingWords = {};
  try {
    history.replaceState(null, '', fragment ? `#${fragment}` : location.pathname + location.search);
  } catch {
    // A frame without its own URL stores nothing.
  }
}

/** The URL of the current state. @param {Player} player */
function addressOfNow(player) {
  const fragment = fragmentWith({
    ...pendingWords,
    t: player.clock.time.toFixed(2),
    paused: player.isPlaying ? null : '',
  });
  return `${location.href.replace(/#.*$/, '')}#${fragment}`;
}

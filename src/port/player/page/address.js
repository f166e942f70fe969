// What the address says, and what is kept in it:
// `#size=320x180&t=2.5&paused&scale=0.5&bar=off&embed&u.SPEED=2&u.TINT=1,0.5,0`.

/** The numbers that stand for a slider or another control. @param {string} text */
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
    isEmbedded: words.has('embed'),
    hasBar: words.get('bar') !== 'off' && !words.has('embed'),
    values,
  };
}

/** The fragment with some of its words changed; null takes one out. @param {Record<string, string | null>} changes */
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

/** Keeps words in the address. Browsers allow that a few times a second only. @param {Record<string, string | null>} changes */
function keepInAddress(changes) {
  Object.assign(pendingWords, changes);
  clearTimeout(pendingWrite);
  pendingWrite = setTimeout(writeAddress, 250);
}

/** Writes what is to be kept, now. */
function writeAddress() {
  const fragment = fragmentWith(pendingWords);
  pendingWords = {};
  try {
    history.replaceState(null, '', fragment ? `#${fragment}` : location.pathname + location.search);
  } catch {
    // A frame without an address of its own keeps nothing.
  }
}

/** The address that shows what is seen now. @param {Player} player */
function addressOfNow(player) {
  const fragment = fragmentWith({
    ...pendingWords,
    t: player.clock.time.toFixed(2),
    paused: player.isPlaying ? null : '',
  });
  return `${location.href.replace(/#.*$/, '')}#${fragment}`;
}

// Writing state to the URL.

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

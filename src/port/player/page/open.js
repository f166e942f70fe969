// Opening the player: what all pages share.

/** Opens the player, or shows why that fails. @param {ProjectData} project */
function openPlayer(project) {
  try {
    return new Player(element('canvas', HTMLCanvasElement), project);
  } catch (error) {
    showFailure(error);
    return null;
  }
}

/** Shows why the player has no context. @param {unknown} error */
function showFailure(error) {
  const box = element('errors', HTMLElement);
  box.replaceChildren(make('h2', error instanceof Error ? error.message : String(error)));
  box.hidden = false;
}

/** Starts playing, unless the URL or the settings of the user prevent it; then a button starts it. @param {Player} player */
function begin(player) {
  const asked = readAddress();
  const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (asked.time !== null) player.seek(asked.time);
  if (!asked.isPaused && !isCalm) return player.play();
  player.poke();
  const button = element('begin', HTMLButtonElement);
  button.hidden = asked.isPaused && window.parent === window;
  button.addEventListener('click', () => {
    player.play();
    player.canvas.focus();
  });
  player.listeners.push(() => {
    if (player.isPlaying) button.hidden = true;
  });
  return undefined;
}

/** Applies changes of the URL. @param {Player} player */
function followAddress(player) {
  window.addEventListener('hashchange', () => {
    const { time, isPaused } = readAddress();
    if (time !== null) player.seek(time);
    if (isPaused) player.pause();
  });
}

/** What all pages do with a player. @param {Player} player */
function attach(player) {
  showControls(player);
  listenToPointer(player);
  listenToKeys(player);
  listenToShortcuts(player);
  showClock(player);
  hideBarWhenIdle(player);
  followAddress(player);
  watchContext(player);
}

/** The API for tests and embedding pages. @param {Player} player @param {Promise<void>} ready */
function publicFace(player, ready) {
  return {
    ready,
    /** @param {number} n */
    renderFrame: async (n) => {
      await player.open();
      await ready;
      await player.renderFrame(n);
    },
    /** @param {number} t */
    seek: (t) => player.seek(t),
    /** @param {number} x @param {number} y @param {boolean} down */
    setMouse: (x, y, down) => player.setMouse(x, y, down),
    /** @param {number} code @param {boolean} down */
    setKey: (code, down) => player.setKey(code, down),
    get errors() {
      return player.errors.map(({ pass, line, text }) => ({ pass, line, text }));
    },
    player,
  };
}

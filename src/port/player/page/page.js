// The page around the player.

/** Opens the player, or shows why that fails. @param {ProjectData} project */
function openPlayer(project) {
  try {
    return new Player(element('canvas', HTMLCanvasElement), project);
  } catch (error) {
    const box = element('errors', HTMLElement);
    box.replaceChildren(make('h2', error instanceof Error ? error.message : String(error)));
    box.hidden = false;
    return null;
  }
}

/** Starts playing, unless the URL or the settings of the user prevent it; then a button starts it. @param {Player} player */
function begin(player) {
  const asked = readAddress();
  const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (asked.time !== null) player.seek(asked.time);
  if (!asked.isPaused && !isCalm) return player.play();
  player.poke();
  const button = element('begin', HTMLButtonElement);
  button.hidden = asked.isPaused && !asked.isEmbedded;
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

/** Builds the page for the embedded project. Returns its player, or null. */
function openPage() {
  /** @type {ProjectData} */
  const project = JSON.parse(element('project', HTMLScriptElement).textContent ?? '');
  const { hasBar, isEmbedded } = readAddress();
  document.body.classList.toggle('bare', !hasBar);
  document.body.classList.toggle('embedded', isEmbedded);
  showAbout(project);
  const player = openPlayer(project);
  if (!player) return null;
  checkedTexts.push(...project.files.map((f) => f.text));
  showPanel();
  showErrors(player);
  showControls(player);
  showSliders(player);
  showCode(player);
  showExport(player);
  fitCanvas(player);
  listenToPointer(player);
  listenToKeys(player);
  listenToShortcuts(player);
  showClock(player);
  hideBarWhenIdle(player);
  followAddress(player);
  watchContext(player);
  const ready = player.ready.then(() => {
    showChannels(player);
    begin(player);
    watchSpeed(player);
  });
  Object.assign(window, { shaderport: publicFace(player, ready) });
  return player;
}

/** The API for tests and embedding pages. @param {Player} player @param {Promise<void>} ready */
function publicFace(player, ready) {
  return {
    ready,
    /** @param {number} n */
    renderFrame: async (n) => {
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

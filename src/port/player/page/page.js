// The page around the player: controls, error panel, sliders, files for channels.

/** @template {HTMLElement} T @param {string} id @param {new () => T} type @returns {T} */
function element(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${id}`);
  return found;
}

/**
 * @param {string} tag @param {string} [text] @param {string} [className]
 * @returns {HTMLElement}
 */
function make(tag, text = '', className = '') {
  const node = document.createElement(tag);
  node.textContent = text;
  node.className = className;
  return node;
}

/** What the address asks for: `#size=320x180&t=2.5&paused`. */
function readAddress() {
  const words = new URLSearchParams(location.hash.slice(1));
  const size = /^(\d{1,4})x(\d{1,4})$/.exec(words.get('size') ?? '');
  const time = Number(words.get('t') ?? NaN);
  return {
    size: size ? [Number(size[1]), Number(size[2])] : null,
    time: Number.isFinite(time) ? time : null,
    isPaused: words.has('paused'),
  };
}

/** Keeps the canvas as large as it is shown, times the chosen scale. @param {Player} player */
function fitCanvas(player) {
  const { canvas } = player;
  const scale = element('scale', HTMLSelectElement);
  const { size } = readAddress();
  if (size) {
    canvas.style.width = `${size[0]}px`;
    canvas.style.height = `${size[1]}px`;
    player.resize(size[0], size[1]);
    scale.hidden = true;
    return;
  }
  const apply = fitToElement(player, () => Number(scale.value));
  scale.addEventListener('change', apply);
}

const PLAY = 'M4 2l10 6-10 6z';
const PAUSE = 'M3 2h4v12H3zM9 2h4v12H9z';

/** @param {Player} player */
function showControls(player) {
  const play = element('play', HTMLButtonElement);
  const icon = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  icon.setAttribute('viewBox', '0 0 16 16');
  icon.append(path);
  play.append(icon);
  play.addEventListener('click', () => (player.isPlaying ? player.pause() : player.play()));
  element('restart', HTMLButtonElement).addEventListener('click', () => player.restart());
  const scrub = element('scrub', HTMLInputElement);
  scrub.addEventListener('input', () => player.seek(Number(scrub.value)));
  const sound = element('sound', HTMLButtonElement);
  sound.hidden = !player.hasSound;
  sound.addEventListener('click', () => player.setSound(!player.isSoundOn));
  element('full', HTMLButtonElement).addEventListener('click', () => {
    if (document.fullscreenElement) void document.exitFullscreen();
    else void element('stage', HTMLElement).requestFullscreen();
  });
  const more = element('more', HTMLButtonElement);
  const panel = element('panel', HTMLElement);
  more.addEventListener('click', () => {
    panel.hidden = !panel.hidden;
    more.setAttribute('aria-expanded', String(!panel.hidden));
  });
  player.listeners.push(() => {
    path.setAttribute('d', player.isPlaying ? PAUSE : PLAY);
    sound.setAttribute('aria-pressed', String(player.isSoundOn));
  });
}

/** The bar goes away while nobody moves and the shader plays. @param {Player} player */
function hideBarWhenIdle(player) {
  const stage = element('stage', HTMLElement);
  let timer = 0;
  const wake = () => {
    stage.classList.remove('idle');
    clearTimeout(timer);
    timer = setTimeout(() => {
      const isUsed = element('bar', HTMLElement).matches(':hover, :focus-within');
      const isOpen = !element('panel', HTMLElement).hidden;
      stage.classList.toggle('idle', player.isPlaying && !isUsed && !isOpen);
    }, 2500);
  };
  for (const name of ['pointermove', 'pointerdown', 'focusin']) document.addEventListener(name, wake);
  player.listeners.push(wake);
}

/** Shows time and frame rate as they change. @param {Player} player */
function showClock(player) {
  const time = element('time', HTMLOutputElement);
  const rate = element('rate', HTMLOutputElement);
  const scrub = element('scrub', HTMLInputElement);
  const show = () => {
    const now = player.clock.time;
    time.value = now.toFixed(2);
    rate.value = player.isPlaying ? `${player.clock.rate.toFixed(0)} fps` : '';
    if (now > Number(scrub.max)) scrub.max = String(2 * now);
    if (document.activeElement !== scrub || player.isPlaying) scrub.value = String(now);
    requestAnimationFrame(show);
  };
  show();
}

/** Opens the player; where that fails, the page says why. @param {ProjectData} project */
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

/** Builds the page around the project that it holds; gives its player, where there is one. */
function openPage() {
  /** @type {ProjectData} */
  const project = JSON.parse(element('project', HTMLScriptElement).textContent ?? '');
  showCredits(project);
  const player = openPlayer(project);
  if (!player) return null;
  showErrors(player);
  showControls(player);
  showCapture(player);
  showSliders(player);
  showChannels(player);
  fitCanvas(player);
  listenToPointer(player);
  listenToKeys(player);
  showClock(player);
  hideBarWhenIdle(player);
  const asked = readAddress();
  const ready = player.ready.then(() => {
    if (asked.time !== null) player.seek(asked.time);
    else if (asked.isPaused) player.poke();
    if (!asked.isPaused) player.play();
  });
  Object.assign(window, { shaderport: publicFace(player, ready) });
  return player;
}

/** What tests and pages around this one may use. @param {Player} player @param {Promise<void>} ready */
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

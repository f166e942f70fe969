// The bar below the picture: play, time, size, full screen.

const PLAY = 'M4 2l10 6-10 6z';
const PAUSE = 'M3 2h4v12H3zM9 2h4v12H9z';
/** Frames that take longer than this, in seconds, are slow. */
const SLOW = 0.25;

/** @param {Player} player */
function togglePlay(player) {
  if (player.isPlaying) player.pause();
  else player.play();
}

function toggleFullScreen() {
  if (document.fullscreenElement) void document.exitFullscreen();
  else void element('stage', HTMLElement).requestFullscreen().catch(() => {});
}

/** @param {Player} player */
function showControls(player) {
  const play = element('play', HTMLButtonElement);
  const icon = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  icon.setAttribute('viewBox', '0 0 16 16');
  icon.append(path);
  play.append(icon);
  play.addEventListener('click', () => togglePlay(player));
  element('restart', HTMLButtonElement).addEventListener('click', () => player.restart());
  const scrub = element('scrub', HTMLInputElement);
  scrub.addEventListener('input', () => player.seek(Number(scrub.value)));
  const sound = element('sound', HTMLButtonElement);
  sound.addEventListener('click', () => player.setSound(!player.isSoundOn));
  const full = element('full', HTMLButtonElement);
  full.hidden = !document.fullscreenEnabled;
  full.addEventListener('click', toggleFullScreen);
  const show = () => {
    path.setAttribute('d', player.isPlaying ? PAUSE : PLAY);
    play.setAttribute('aria-label', player.isPlaying ? 'pause' : 'play');
    sound.hidden = !player.hasSound;
    sound.setAttribute('aria-pressed', String(player.isSoundOn));
  };
  player.listeners.push(show);
  show();
}

/**
 * The bar goes away while nobody uses it: in the window while the shader plays, in full screen, where it
 * lies over the picture, always.
 * @param {Player} player
 */
function hideBarWhenIdle(player) {
  const stage = element('stage', HTMLElement);
  const bar = element('bar', HTMLElement);
  let timer = 0;
  let isOver = false;
  const sleep = () => {
    const isUsed = isOver || bar.matches(':has(:focus-visible)');
    const isWanted = isUsed || !player.isPlaying || !element('panel', HTMLElement).hidden;
    stage.classList.toggle('idle', document.fullscreenElement !== null || !isWanted);
  };
  const wake = () => {
    stage.classList.remove('idle');
    clearTimeout(timer);
    timer = setTimeout(sleep, 2500);
  };
  bar.addEventListener('pointerenter', (event) => {
    isOver = event.pointerType === 'mouse';
  });
  bar.addEventListener('pointerleave', () => {
    isOver = false;
  });
  for (const name of ['pointermove', 'pointerdown', 'focusin', 'keydown']) document.addEventListener(name, wake);
  document.addEventListener('fullscreenchange', sleep);
  player.listeners.push(wake);
  wake();
}

/** Shows time and frame rate as they change. @param {Player} player */
function showClock(player) {
  const time = element('time', HTMLOutputElement);
  const rate = element('rate', HTMLOutputElement);
  const scrub = element('scrub', HTMLInputElement);
  const show = () => {
    const now = player.clock.time;
    const shownRate = player.clock.rate < 10 ? player.clock.rate.toFixed(1) : player.clock.rate.toFixed(0);
    time.value = now.toFixed(2);
    rate.value = player.isPlaying ? `${shownRate} fps` : '';
    if (now > Number(scrub.max)) scrub.max = String(2 * now);
    if (document.activeElement !== scrub || player.isPlaying) scrub.value = String(now);
    requestAnimationFrame(show);
  };
  show();
}

/**
 * How the canvas gets its size: `isHeld` keeps it whatever happens around it, as while a film is made;
 * `fit` gives it the size of its place.
 */
const canvasSize = { isHeld: false, fit: () => {} };

/** Keeps the canvas as large as it is shown, times the chosen scale. @param {Player} player */
function fitCanvas(player) {
  const { canvas } = player;
  const scale = element('scale', HTMLSelectElement);
  const asked = readAddress();
  if (asked.size) {
    const [width, height] = asked.size;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.classList.add('sized');
    scale.hidden = true;
    canvasSize.fit = () => player.resize(width, height);
    canvasSize.fit();
    return;
  }
  if (asked.scale) {
    const word = String(asked.scale);
    if (![...scale.options].some((o) => o.value === word)) scale.add(new Option(`${word}×`, word));
    scale.value = word;
  }
  canvasSize.fit = fitToElement(player, () => (canvasSize.isHeld ? null : Number(scale.value)));
  scale.addEventListener('change', () => {
    keepInAddress({ scale: scale.value === '1' ? null : scale.value });
    canvasSize.fit();
    retract('slow');
  });
}

/**
 * Where frames take long, says how they would take less. The first frames are not counted: shaders are
 * made ready in them.
 * @param {Player} player
 */
function watchSpeed(player) {
  const scale = element('scale', HTMLSelectElement);
  /** @type {number[]} */
  let times = [];
  let last = 0;
  const look = (/** @type {number} */ now) => {
    times = player.isPlaying && document.visibilityState === 'visible' && last > 0 ? [...times, (now - last) / 1000] : [];
    last = player.isPlaying ? now : 0;
    if (times.length < 4) return requestAnimationFrame(look);
    const usual = times.slice(1).sort((a, b) => a - b)[1];
    const next = scale.options[scale.selectedIndex - 1];
    if (usual > SLOW && next && !scale.hidden) {
      notify('slow', `this shader is heavy here: ${(1 / usual).toFixed(1)} frames a second`, {
        label: `draw at ${next.text}`,
        act: () => {
          scale.value = next.value;
          scale.dispatchEvent(new Event('change'));
        },
      });
    }
    times = times.slice(1);
    return requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** Says when the graphics card gives a picture up, which leaves it black. @param {Player} player */
function watchContext({ canvas }) {
  canvas.addEventListener('webglcontextlost', () => notify('lost', 'the graphics card gave up: this shader may be too heavy here'));
  canvas.addEventListener('webglcontextrestored', () => retract('lost'));
}

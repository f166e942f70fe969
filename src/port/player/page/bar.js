// The bar below the image: play, time, size, full screen.

const PLAY = 'M4 2l10 6-10 6z';
const PAUSE = 'M3 2h4v12H3zM9 2h4v12H9z';

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
    play.setAttribute('aria-label', player.isPlaying ? 'Pause' : 'Play');
    sound.hidden = !player.hasSound;
    sound.setAttribute('aria-pressed', String(player.isSoundOn));
  };
  player.listeners.push(show);
  show();
}

/**
 * Hides the bar when it is not in use: in a window while the shader plays, and always in full screen, where
 * it covers the image.
 * @param {Player} player
 */
function hideBarWhenIdle(player) {
  const stage = element('stage', HTMLElement);
  const bar = element('bar', HTMLElement);
  let timer = 0;
  let isOver = false;
  const sleep = () => {
    const isUsed = isOver || bar.matches(':has(:focus-visible)');
    const isWanted = isUsed || !player.isPlaying || document.querySelector('#panel:not([hidden])') !== null;
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

/** Updates the time. @param {Player} player */
function showClock(player) {
  const time = element('time', HTMLOutputElement);
  const scrub = element('scrub', HTMLInputElement);
  const show = () => {
    const now = player.clock.time;
    time.value = now.toFixed(2);
    if (now > Number(scrub.max)) scrub.max = String(2 * now);
    if (document.activeElement !== scrub || player.isPlaying) scrub.value = String(now);
    requestAnimationFrame(show);
  };
  show();
}

/** Shows a notice when the browser takes the WebGL context away. @param {Player} player */
function watchContext({ canvas, context }) {
  canvas.addEventListener('webglcontextlost', () => {
    if (context.isGivenBack) return;
    notify('lost', 'WebGL context lost: this shader may be too slow for this device, or too many shaders play at once');
  });
  canvas.addEventListener('webglcontextrestored', () => retract('lost'));
}

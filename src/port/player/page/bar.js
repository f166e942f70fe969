// The bar below the image: play, time, size, full screen.

const PLAY = 'M4 2l10 6-10 6z';
const PAUSE = 'M3 2h4v12H3zM9 2h4v12H9z';
/** Frame duration in seconds above which a shader counts as slow. */
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

/** Updates time and frame rate. @param {Player} player */
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
 * The size of the canvas: `isHeld` prevents changes, as during a recording; `fit` sets it to the displayed
 * size.
 */
const canvasSize = { isHeld: false, fit: () => {} };

/** Keeps the canvas resolution at its displayed size, times the selected scale. @param {Player} player */
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
 * Suggests a lower resolution if frames are slow. The first frames are not counted, since shaders are
 * prepared in them.
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
      notify('slow', `This shader is slow on this device: ${(1 / usual).toFixed(1)} fps`, {
        label: `Render at ${next.text}`,
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

/** Shows a notice when the WebGL context is lost, which leaves the canvas black. @param {Player} player */
function watchContext({ canvas }) {
  canvas.addEventListener('webglcontextlost', () => notify('lost', 'WebGL context lost: this shader may be too slow for this device'));
  canvas.addEventListener('webglcontextrestored', () => retract('lost'));
}

// The resolution of the canvas and the frame rate.

/** Frame duration in seconds above which a shader counts as slow. */
const SLOW = 0.25;

/** Updates the frame rate. @param {Player} player */
function showRate(player) {
  const rate = element('rate', HTMLOutputElement);
  const show = () => {
    const shown = player.clock.rate < 10 ? player.clock.rate.toFixed(1) : player.clock.rate.toFixed(0);
    rate.value = player.isPlaying ? `${shown} fps` : '';
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
    canvas.style.width = `min(${width}px, 100cqw, ${(100 * width) / height}cqh)`;
    canvas.style.aspectRatio = `${width} / ${height}`;
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

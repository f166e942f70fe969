// User input on the canvas: pointer, keys, size.

/**
 * Forwards mouse, touch and pen input to `iMouse`.
 * @param {Player} player @param {AbortSignal} [signal] removes the listeners
 */
function listenToPointer(player, signal) {
  const { canvas } = player;
  /** @param {PointerEvent} event @returns {[number, number]} */
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) * canvas.width) / box.width;
    const y = canvas.height - ((event.clientY - box.top) * canvas.height) / box.height;
    return [x, y];
  };
  /** @type {number | null} the pointer that acts as the mouse; others are ignored meanwhile */
  let held = null;
  canvas.addEventListener('pointerdown', (event) => {
    if (held !== null || (event.button !== 0 && event.pointerType === 'mouse')) return;
    held = event.pointerId;
    canvas.focus();
    canvas.setPointerCapture(held);
    player.setMouse(...place(event), true);
    player.poke();
  }, { signal });
  canvas.addEventListener('pointermove', (event) => {
    if (held !== null && event.pointerId !== held) return;
    player.mouse.move(...place(event));
    if (held !== null || player.followsPointer) player.poke();
  }, { signal });
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    canvas.addEventListener(name, (event) => {
      if (!(event instanceof PointerEvent) || event.pointerId !== held) return;
      held = null;
      player.mouse.release();
      player.poke();
    }, { signal });
  }
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
}

/** Whether some pass reads the keyboard. @param {Player} player */
function readsKeys(player) {
  return player.project.passes.some((pass) => pass.inputs.some((input) => input?.kind === 'keyboard'));
}

/**
 * Forwards keys while the canvas has focus, if the shader reads the keyboard.
 * @param {Player} player @param {AbortSignal} [signal] removes the listeners
 */
function listenToKeys(player, signal) {
  const { canvas } = player;
  if (!readsKeys(player)) return;
  /** @param {KeyboardEvent} event @param {boolean} isDown */
  const handle = (event, isDown) => {
    player.setKey(event.keyCode, isDown);
    // Browser shortcuts and leaving the canvas by Tab still work.
    const isShortcut = event.ctrlKey || event.metaKey || event.altKey || event.key === 'Tab';
    if (!isShortcut && !/^F\d+$/.test(event.key)) event.preventDefault();
    if (!event.repeat) player.poke();
  };
  canvas.addEventListener('keydown', (event) => handle(event, true), { signal });
  canvas.addEventListener('keyup', (event) => handle(event, false), { signal });
  canvas.addEventListener('blur', () => player.keyboard?.releaseAll(), { signal });
}

/**
 * Keeps the canvas resolution equal to its displayed size in device pixels, times a scale.
 * @param {Player} player @param {() => number | null} scale null keeps the current size @param {AbortSignal} [signal] stops observing
 * @returns {() => void} to be called when the scale has changed
 */
function fitToElement(player, scale, signal) {
  const { canvas } = player;
  const rounded = () => [
    Math.round(canvas.offsetWidth * devicePixelRatio),
    Math.round(canvas.offsetHeight * devicePixelRatio),
  ];
  let [width, height] = rounded();
  const apply = () => {
    const factor = scale();
    if (factor !== null) player.resize(width * factor, height * factor);
  };
  const observer = new ResizeObserver(([entry]) => {
    const box = entry.devicePixelContentBoxSize?.[0];
    [width, height] = box ? [box.inlineSize, box.blockSize] : rounded();
    apply();
  });
  try {
    observer.observe(canvas, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(canvas);
  }
  signal?.addEventListener('abort', () => observer.disconnect());
  apply();
  return apply;
}

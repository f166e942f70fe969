// What the user does to the canvas: pointer, keys, size.

/**
 * Feeds the mouse, a finger or a pen to `iMouse`.
 * @param {Player} player @param {AbortSignal} [signal] ends it
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
  /** @type {number | null} the pointer that is the mouse; the others do nothing meanwhile */
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
 * Keys count while the canvas has the focus, if the shader reads them.
 * @param {Player} player @param {AbortSignal} [signal] ends it
 */
function listenToKeys(player, signal) {
  const { canvas } = player;
  if (!readsKeys(player)) return;
  /** @param {KeyboardEvent} event @param {boolean} isDown */
  const handle = (event, isDown) => {
    player.setKey(event.keyCode, isDown);
    // Shortcuts of the browser and the way out of the canvas stay.
    const isShortcut = event.ctrlKey || event.metaKey || event.altKey || event.key === 'Tab';
    if (!isShortcut && !/^F\d+$/.test(event.key)) event.preventDefault();
    if (!event.repeat) player.poke();
  };
  canvas.addEventListener('keydown', (event) => handle(event, true), { signal });
  canvas.addEventListener('keyup', (event) => handle(event, false), { signal });
  canvas.addEventListener('blur', () => player.keyboard.releaseAll(), { signal });
}

/**
 * Keeps the canvas as large as it is shown, times a scale, in pixels of the device.
 * @param {Player} player @param {() => number | null} scale null while the size shall stay @param {AbortSignal} [signal] ends it
 * @returns {() => void} call it when the scale has changed
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

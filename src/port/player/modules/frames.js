// Frames of the modules for three.js.

/** The state of a frame that passes read. */
function tickOf(number, time, delta, mouse) {
  const pointer = mouse ? { x: mouse[0], y: mouse[1], isDown: mouse[2] > 0 } : null;
  const rate = 1 / Math.max(delta, 1e-3);
  return { number, time, delta, rate, mouse: mouse ?? [0, 0, 0, 0], pointer, date: dateUniform() };
}

/** Draws into targets, in which discarded pixels keep their values from two frames ago. */
function drawTargets(renderer, draw) {
  const before = renderer.getRenderTarget();
  const { autoClear } = renderer;
  renderer.autoClear = false;
  draw();
  renderer.setRenderTarget(before);
  renderer.autoClear = autoClear;
}

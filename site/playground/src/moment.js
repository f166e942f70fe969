// The frame that the image shows, for runs on the processor.

/**
 * The options of a run for what the image shows.
 * @param {any} [state] of the image; undefined if there is none
 */
export function momentOf(state) {
  if (!state) return { time: 0 };
  const { time, frame, mouse, controls } = state;
  const isPressed = mouse.clickX !== 0 || mouse.clickY !== 0;
  return {
    time,
    frame,
    ...(isPressed && { mouse: { x: mouse.x, y: mouse.y } }),
    ...(Object.keys(controls).length > 0 && { uniforms: controls }),
  };
}

// The frame and the pass that are looked at, for runs on the processor.
import { IMAGE, isFolder } from './passes.js';

/** The option of a run that chooses the buffer whose tab is open; nothing for the image. */
export const passOf = ({ files, current }) =>
  (isFolder(files) && current !== IMAGE && /^buffer_/.test(current) ? { pass: current.replace('.glsl', '') } : {});

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

// What a page keeps of the player when it shows another version of the shader.

/** Time, mouse, the open tab, and what is drawn where. @param {Player} player */
function stateOf({ canvas, clock, controls, mouse, isPlaying }) {
  const { x, y, clickX, clickY } = mouse;
  const tab = TABS.find(({ id }) => isTabOpen(id))?.id;
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return {
    time: clock.time,
    frame: clock.shown,
    isPlaying,
    mouse: { x, y, clickX, clickY },
    tab,
    size: [canvas.width, canvas.height],
    box: { left, top, width, height },
    controls: Object.fromEntries(controls),
  };
}

/** @param {Player} player @param {ReturnType<typeof stateOf>} state */
function takeState(player, state) {
  Object.assign(player.mouse, state.mouse);
  if (state.tab) openTab(state.tab);
  if (state.isPlaying) player.play();
  else player.pause();
  // A player that stands still draws the frame of the new time.
  player.seek(state.time);
}

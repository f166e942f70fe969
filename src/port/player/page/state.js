// What a page keeps of the player when it shows another version of the shader.

/** Time, mouse and the open tab. @param {Player} player */
function stateOf({ clock, mouse, isPlaying }) {
  const { x, y, clickX, clickY } = mouse;
  const tab = TABS.find(({ id }) => isTabOpen(id))?.id;
  return { time: clock.time, isPlaying, mouse: { x, y, clickX, clickY }, tab };
}

/** @param {Player} player @param {ReturnType<typeof stateOf>} state */
function takeState(player, state) {
  Object.assign(player.mouse, state.mouse);
  if (state.tab) openTab(state.tab);
  player.seek(state.time);
  if (state.isPlaying) player.play();
  else player.pause();
}

// What a page does that `shaderport --serve` shows: it loads itself anew at each change, and goes on
// where it was.

/** Under which name the state stays while the page is loaded anew. */
const KEPT = 'shaderport.kept';

/**
 * @param {string} version of this page
 * @param {Player | null} player
 */
function followChanges(version, player) {
  if (player) void player.ready.then(() => restoreKept(player));
  new EventSource('events').addEventListener('message', ({ data }) => {
    if (data === version) return;
    if (player) keep(player);
    location.reload();
  });
}

/** @param {Player} player */
function keep({ clock, mouse, isPlaying }) {
  const { x, y, clickX, clickY } = mouse;
  const state = { time: clock.time, isPlaying, mouse: { x, y, clickX, clickY } };
  sessionStorage.setItem(KEPT, JSON.stringify(state));
}

/** @param {Player} player */
function restoreKept(player) {
  const kept = sessionStorage.getItem(KEPT);
  sessionStorage.removeItem(KEPT);
  if (!kept) return;
  const state = JSON.parse(kept);
  Object.assign(player.mouse, state.mouse);
  player.seek(state.time);
  if (state.isPlaying) player.play();
  else player.pause();
}

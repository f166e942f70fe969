// Keyboard shortcuts.

/** Steps one frame while paused, and five seconds while playing. @param {Player} player @param {number} way */
function jump(player, way) {
  if (player.isPlaying) player.seek(player.clock.time + 5 * way);
  else if (way > 0) player.step();
  else player.seek(player.clock.time - FIRST_DELTA);
}

/** @type {{keys: string[], shown: string, words: string, act: (player: Player) => void}[]} */
const SHORTCUTS = [
  { keys: [' '], shown: 'space', words: 'Play or pause', act: togglePlay },
  { keys: ['ArrowLeft'], shown: '←', words: 'Back 5 seconds, or one frame while paused', act: (player) => jump(player, -1) },
  { keys: ['ArrowRight'], shown: '→', words: 'Forward 5 seconds, or one frame while paused', act: (player) => jump(player, 1) },
  { keys: ['r', 'R'], shown: 'r', words: 'Restart', act: (player) => player.restart() },
  { keys: ['f', 'F'], shown: 'f', words: 'Full screen', act: toggleFullScreen },
];

/** Whether the focused element handles this key itself. @param {EventTarget | null} target @param {string} key */
function wantsKey(target, key) {
  if (!(target instanceof Element)) return false;
  if (target.matches('textarea, select, input:not([type=checkbox], [type=range]), dialog *')) return true;
  if (target.matches('[type=range], [role=separator], [role=tab]') && key.startsWith('Arrow')) return true;
  return key === ' ' && target.matches('button, a, input');
}

/** @param {Player} player */
function listenToShortcuts(player) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || event.isComposing) return;
    if (wantsKey(event.target, event.key)) return;
    // A shader that reads the keyboard receives all keys while the canvas has focus.
    if (event.target === player.canvas && readsKeys(player)) return;
    const shortcut = SHORTCUTS.find((s) => s.keys.includes(event.key));
    if (!shortcut) return;
    event.preventDefault();
    if (!event.repeat || event.key.startsWith('Arrow')) shortcut.act(player);
  });
}

/** Tells which keys a shader reads, once. @param {Player} player */
function tellKeys(player) {
  if (!readsKeys(player)) return;
  const keys = (player.project.keys ?? []).join(', ');
  notify('keys', keys ? `Click the image, then use ${keys}` : 'This shader reads the keyboard: click the image first');
  player.canvas.addEventListener('focus', () => setTimeout(() => retract('keys'), 2000), { once: true });
}

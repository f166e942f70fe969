// Keyboard shortcuts and their list.

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
  { keys: ['s', 'S'], shown: 's', words: 'Save an image', act: savePicture },
  { keys: ['c', 'C'], shown: 'c', words: 'Show or hide the code', act: () => (isTabOpen('code') ? closePanel() : openTab('code')) },
  { keys: ['?'], shown: '?', words: 'Show or hide this list', act: (player) => toggleHelp(player) },
];

/** @param {Player} player */
function toggleHelp(player) {
  const dialog = element('keys', HTMLDialogElement);
  if (dialog.open) return dialog.close();
  const list = make('dl');
  for (const { shown, words } of SHORTCUTS) list.append(make('dt', shown), make('dd', words));
  list.append(make('dt', 'esc'), make('dd', 'Leave the code editor, or close the panel'));
  const notes = readsKeys(player) ? [make('p', 'This shader reads the keyboard. While the image has focus, it receives all keys except Tab. To use the shortcuts, press Tab or click outside the image.')] : [];
  const close = makeButton('×', () => dialog.close(), 'Close');
  dialog.replaceChildren(close, make('h2', 'Keyboard shortcuts'), list, ...notes);
  return dialog.showModal();
}

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
  element('help', HTMLElement).addEventListener('click', () => toggleHelp(player));
}

// Shortcuts, and the table of them.

/** Goes a frame where the clock stands, and five seconds where it runs. @param {Player} player @param {number} way */
function jump(player, way) {
  if (player.isPlaying) player.seek(player.clock.time + 5 * way);
  else if (way > 0) player.step();
  else player.seek(player.clock.time - FIRST_DELTA);
}

/** @type {{keys: string[], shown: string, words: string, act: (player: Player) => void}[]} */
const SHORTCUTS = [
  { keys: [' '], shown: 'space', words: 'play or pause', act: togglePlay },
  { keys: ['ArrowLeft'], shown: '←', words: 'five seconds back; a frame while paused', act: (player) => jump(player, -1) },
  { keys: ['ArrowRight'], shown: '→', words: 'five seconds on; a frame while paused', act: (player) => jump(player, 1) },
  { keys: ['r', 'R'], shown: 'r', words: 'restart', act: (player) => player.restart() },
  { keys: ['f', 'F'], shown: 'f', words: 'full screen', act: toggleFullScreen },
  { keys: ['s', 'S'], shown: 's', words: 'save a picture', act: savePicture },
  { keys: ['c', 'C'], shown: 'c', words: 'the code', act: () => (isTabOpen('code') ? closePanel() : openTab('code')) },
  { keys: ['?'], shown: '?', words: 'these keys', act: (player) => toggleHelp(player) },
];

/** @param {Player} player */
function toggleHelp(player) {
  const dialog = element('keys', HTMLDialogElement);
  if (dialog.open) return dialog.close();
  const list = make('dl');
  for (const { shown, words } of SHORTCUTS) list.append(make('dt', shown), make('dd', words));
  list.append(make('dt', 'esc'), make('dd', 'leave the code; close the panel'));
  const notes = readsKeys(player) ? [make('p', 'This shader reads the keyboard: while the picture has the focus, all keys but Tab go to it. Press Tab, or click beside the picture, to use these.')] : [];
  const close = makeButton('×', () => dialog.close(), 'close');
  dialog.replaceChildren(close, make('h2', 'Keys'), list, ...notes);
  return dialog.showModal();
}

/** Whether what has the focus wants this key itself. @param {EventTarget | null} target @param {string} key */
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
    // Keys of a shader that reads them are its own while the picture has the focus.
    if (event.target === player.canvas && readsKeys(player)) return;
    const shortcut = SHORTCUTS.find((s) => s.keys.includes(event.key));
    if (!shortcut) return;
    event.preventDefault();
    if (!event.repeat || event.key.startsWith('Arrow')) shortcut.act(player);
  });
  element('help', HTMLElement).addEventListener('click', () => toggleHelp(player));
}

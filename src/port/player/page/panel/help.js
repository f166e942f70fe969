// Keyboard shortcuts of the panel, and the list of all.

SHORTCUTS.push(
  { keys: ['s', 'S'], shown: 's', words: 'Save an image', act: savePicture },
  { keys: ['c', 'C'], shown: 'c', words: 'Show or hide the code', act: () => (isTabOpen('code') ? closePanel() : openTab('code')) },
  { keys: ['?'], shown: '?', words: 'Show or hide this list', act: (player) => toggleHelp(player) },
);

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

/** @param {Player} player */
function listenToHelp(player) {
  element('help', HTMLElement).addEventListener('click', () => toggleHelp(player));
}

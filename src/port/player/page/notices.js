// Dismissible notices on the image.

/** @type {Map<string, HTMLElement>} */
const notices = new Map();
/** Names of dismissed notices, which are not shown again. @type {Set<string>} */
const dismissed = new Set();

/**
 * Shows a notice. It replaces a notice with the same name.
 * @param {string} name
 * @param {string} text
 * @param {{label: string, act: () => void}} [action]
 */
function notify(name, text, action) {
  if (dismissed.has(name)) return;
  const notice = make('div', '', 'notice');
  notice.append(make('span', text));
  if (action) notice.append(makeButton(action.label, action.act));
  notice.append(makeButton('×', () => {
    dismissed.add(name);
    retract(name);
  }, 'Dismiss'));
  const old = notices.get(name);
  if (old?.textContent === notice.textContent) return;
  retract(name);
  notices.set(name, notice);
  element('notices', HTMLElement).append(notice);
}

/** Removes a notice. @param {string} name */
function retract(name) {
  notices.get(name)?.remove();
  notices.delete(name);
}

// Small notices on the picture, each of which can be taken away.

/** @type {Map<string, HTMLElement>} */
const notices = new Map();
/** Those that the user has taken away, which do not come again. @type {Set<string>} */
const dismissed = new Set();

/**
 * Says something on the picture. One of the same name is replaced.
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
  }, 'dismiss'));
  const old = notices.get(name);
  if (old?.textContent === notice.textContent) return;
  retract(name);
  notices.set(name, notice);
  element('notices', HTMLElement).append(notice);
}

/** Takes a notice away. @param {string} name */
function retract(name) {
  notices.get(name)?.remove();
  notices.delete(name);
}

/** Says something for a few seconds. @param {string} text */
function flash(text) {
  dismissed.delete('flash');
  retract('flash');
  notify('flash', text);
  const shown = notices.get('flash');
  setTimeout(() => {
    if (shown && notices.get('flash') === shown) retract('flash');
  }, 4000);
}

// DOM helpers.

/** @template {HTMLElement} T @param {string} id @param {new () => T} type @returns {T} */
function element(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no element #${id}`);
  return found;
}

/**
 * @param {string} tag @param {string} [text] @param {string} [className]
 * @returns {HTMLElement}
 */
function make(tag, text = '', className = '') {
  const node = document.createElement(tag);
  node.textContent = text;
  if (className) node.className = className;
  return node;
}

/** @param {string} text @param {() => void} act @param {string} [title] */
function makeButton(text, act, title = '') {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = text;
  if (title) {
    button.title = title;
    button.setAttribute('aria-label', title);
  }
  button.addEventListener('click', act);
  return button;
}

/** What only some pages have. @type {{showChannels?: (player: Player) => void, showDebug?: (player: Player) => void, showSliders?: (player: Player) => void, takeValues?: (player: Player) => void}} */
const pageParts = {};

// Examples: shaders of the repository, and the code of the pages of rules. They are loaded when somebody
// wants to see them.
import { element } from './element.js';
import { FIRST } from './first.js';

/** @typedef {{ name: string, file: string, text: string }} Example */
/** @typedef {{ label: string, summary?: string, examples: Example[] }} Group */

/** All examples, by group. @returns {Promise<Group[]>} */
async function load() {
  const response = await fetch(new URL('examples.json', document.baseURI));
  if (!response.ok) throw new Error(`the examples cannot be loaded (status ${response.status})`);
  const start = { label: 'Start', examples: [{ name: 'wave.glsl', file: 'wave.glsl', text: FIRST }] };
  return [start, ...await response.json()];
}

/** A group of examples as an element, and the words that find it. */
function groupOf({ label, summary = '', examples }, choose) {
  const buttons = examples.map((example) => {
    const button = element('button', { type: 'button', textContent: example.name });
    button.addEventListener('click', () => choose({ [example.file]: example.text }));
    return button;
  });
  const words = [label, summary, ...examples.map(({ name }) => name)].join(' ').toLowerCase();
  const shown = element('section', {}, element('h3', { textContent: label }), element('p', { textContent: summary }), element('div', {}, ...buttons));
  return { words, shown };
}

/**
 * Opens a list of the examples with a button.
 * @param {HTMLElement} button
 * @param {(files: import('./passes.js').Files) => void} choose is called with what somebody chose
 */
export function openExamples(button, choose) {
  const filter = element('input', { type: 'search', placeholder: 'Rule or shader' });
  const list = element('div', { className: 'list', textContent: 'Loading…' });
  list.tabIndex = 0;
  const close = element('button', { type: 'button', textContent: 'Close' });
  const head = element('div', { className: 'head' }, element('h2', { id: 'examples-title', textContent: 'Examples' }), element('label', {}, 'Find ', filter), close);
  const dialog = element('dialog', {}, head, list);
  dialog.setAttribute('aria-labelledby', 'examples-title');
  document.body.append(dialog);
  close.addEventListener('click', () => dialog.close());
  /** @type {ReturnType<typeof groupOf>[]} */
  let groups = [];
  const show = () => {
    const words = filter.value.toLowerCase().split(/\s+/);
    for (const group of groups) group.shown.hidden = !words.every((word) => group.words.includes(word));
  };
  filter.addEventListener('input', show);
  button.addEventListener('click', async () => {
    dialog.showModal();
    if (groups.length > 0) return;
    try {
      groups = (await load()).map((group) => groupOf(group, (files) => {
        dialog.close();
        choose(files);
      }));
      list.replaceChildren(...groups.map(({ shown }) => shown));
      show();
    } catch (error) {
      list.textContent = error.message;
    }
  });
}

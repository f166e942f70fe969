// The tabs of the passes, and the menus to add a pass and to set what its channels read.
import { DEVICES, hasChannels } from './channels.js';
import { element } from './element.js';
import { CHANNELS, IMAGE, PASSES, mayBePass, titleOf } from './passes.js';

/** The tab to which a key leads from another one. */
function target(key, at, count) {
  switch (key) {
    case 'ArrowRight': return (at + 1) % count;
    case 'ArrowLeft': return (at + count - 1) % count;
    case 'Home': return 0;
    case 'End': return count - 1;
    default: return -1;
  }
}

/** A menu that a button opens. Escape, and a click elsewhere, close it. */
function menu(id, label) {
  const body = element('div', { className: 'body' });
  const made = element('details', { id, className: 'menu' }, element('summary', { textContent: label }), body);
  const close = () => { made.open = false; };
  made.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !made.open) return;
    close();
    made.querySelector('summary').focus();
  });
  made.addEventListener('focusout', ({ relatedTarget }) => {
    if (relatedTarget && !made.contains(/** @type {Node} */ (relatedTarget))) close();
  });
  document.addEventListener('pointerdown', ({ target: at }) => {
    if (!made.contains(/** @type {Node} */ (at))) close();
  });
  return { made, body, close };
}

/** Shows the tabs of documents in an element. */
export class Tabs {
  #documents;
  #list = element('div', { role: 'tablist', ariaLabel: 'Passes' });
  #add = menu('add', 'Add pass');
  #channels = menu('channels', 'Channels');
  #remove = element('button', { type: 'button', id: 'remove' });

  /**
   * @param {HTMLElement} parent
   * @param {HTMLElement} panel contains the text of the tab
   * @param {import('./documents.js').Documents} documents
   */
  constructor(parent, panel, documents) {
    this.#documents = documents;
    this.#list.addEventListener('keydown', (event) => this.#pressed(event));
    this.#remove.addEventListener('click', () => this.#removeCurrent());
    parent.append(this.#list, this.#add.made, this.#channels.made, this.#remove);
    panel.setAttribute('role', 'tabpanel');
    documents.addEventListener('files', () => {
      this.#show();
      panel.setAttribute('aria-labelledby', this.#list.querySelector('[aria-selected=true]').id);
    });
  }

  #show() {
    const { names, current } = this.#documents;
    const hadFocus = this.#list.contains(document.activeElement);
    this.#list.replaceChildren(...names.map((name) => this.#tab(name, name === current)));
    if (hadFocus) this.#focus();
    const isProject = names.every(mayBePass);
    this.#add.made.hidden = !isProject;
    this.#channels.made.hidden = !isProject || !(hasChannels(current) || names.length === 1);
    this.#remove.hidden = names.length === 1 || current === IMAGE;
    this.#remove.textContent = `Remove ${titleOf(current)}`;
    this.#listMissing(names);
    this.#listChannels(names, current);
  }

  #tab(name, isCurrent) {
    const tab = element('button', { type: 'button', role: 'tab', id: `tab-${name.replace(/\W/g, '-')}`, textContent: titleOf(name) });
    tab.setAttribute('aria-selected', String(isCurrent));
    tab.setAttribute('aria-controls', 'code');
    tab.tabIndex = isCurrent ? 0 : -1;
    tab.addEventListener('click', () => this.#documents.select(name));
    return tab;
  }

  #focus() {
    /** @type {HTMLElement} */ (this.#list.querySelector('[aria-selected=true]')).focus();
  }

  #pressed(event) {
    const { names, current } = this.#documents;
    if (event.key === 'Delete' && !this.#remove.hidden) return this.#removeCurrent();
    const to = target(event.key, names.indexOf(current), names.length);
    if (to < 0) return undefined;
    event.preventDefault();
    this.#documents.select(names[to]);
    return this.#focus();
  }

  #removeCurrent() {
    this.#documents.remove(this.#documents.current);
    this.#focus();
  }

  /** The passes that can be added. */
  #listMissing(names) {
    const missing = PASSES.filter(({ file }) => !names.includes(file) && (file !== IMAGE || names.length > 1));
    const buttons = missing.map(({ file, title }) => {
      const button = element('button', { type: 'button', textContent: title });
      button.addEventListener('click', () => {
        this.#add.close();
        this.#documents.add(file);
        this.#documents.view.focus();
      });
      return button;
    });
    this.#add.body.replaceChildren(...buttons);
  }

  /** What each channel of the pass reads. */
  #listChannels(names, current) {
    const pass = (names.length === 1 ? IMAGE : current).replace('.glsl', '');
    const inputs = names.filter((name) => /^(buffer_|cubemap)/.test(name)).map((name) => [name.replace('.glsl', ''), titleOf(name)]);
    const rows = [0, 1, 2, 3].map((number) => {
      const channel = `${pass}.${number}`;
      const [source = '', ...sampling] = (this.#documents.channels.get(channel) ?? '').split(',');
      const select = element('select', {}, new Option('Automatic', ''));
      for (const [value, label] of [...inputs, ...Object.entries(DEVICES)]) select.append(new Option(label, value));
      select.value = source;
      select.addEventListener('change', () => {
        this.#documents.setChannel(channel, select.value && [select.value, ...sampling].join(','));
        const again = /** @type {HTMLElement} */ (this.#channels.body.querySelectorAll('select')[number]);
        again.focus();
      });
      return element('label', {}, `iChannel${number} `, select);
    });
    this.#channels.body.title = `Saved as ${CHANNELS}`;
    this.#channels.body.replaceChildren(...rows);
  }
}

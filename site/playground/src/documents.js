// The open files, each with an editor of which one is shown.
import { EditorView } from 'codemirror';
import { existing, readChannels, writeChannels } from './channels.js';
import { addressOf, client, editorRoot, openEditor, rename } from './editor.js';
import { CHANNELS, IMAGE, positionOf, startOf } from './passes.js';

/** The files of a shader. It fires `change` when a text or a channel changes, `files` when files come or go, and `breakpoints`. */
export class Documents extends EventTarget {
  #root;
  /** @type {Map<string, import('codemirror').EditorView>} */
  #views = new Map();
  #current = '';
  /** @type {import('./channels.js').Channels} */
  #channels = new Map();

  /** @param {HTMLElement} parent */
  constructor(parent) {
    super();
    this.#root = editorRoot(parent);
    client.workspace.displayFile = (uri) => Promise.resolve(this.show(uri));
  }

  /** The name of the file that is shown. */
  get current() {
    return this.#current;
  }

  /** The editor that is shown. */
  get view() {
    return this.#views.get(this.#current);
  }

  /** The names of all files, in the order of their tabs. */
  get names() {
    return [...this.#views.keys()].sort((a, b) => positionOf(a) - positionOf(b));
  }

  get channels() {
    return existing(this.#channels, this.names);
  }

  /** All files with their texts. @returns {import('./passes.js').Files} */
  get files() {
    const files = Object.fromEntries(this.names.map((name) => [name, this.#views.get(name).state.doc.toString()]));
    const { channels } = this;
    return channels.size > 0 ? { ...files, [CHANNELS]: writeChannels(channels) } : files;
  }

  /** Opens other files instead. @param {import('./passes.js').Files} files */
  open(files) {
    for (const view of this.#views.values()) view.destroy();
    this.#views.clear();
    this.#channels = readChannels(files[CHANNELS]);
    const names = Object.keys(files).filter((name) => name !== CHANNELS);
    // Common comes first: the findings of the others depend on it.
    for (const name of names.sort((a, b) => positionOf(a) - positionOf(b))) this.#create(name, files[name]);
    this.select(IMAGE in files ? IMAGE : names.at(-1));
  }

  /** Adds a pass and shows it. @param {string} file */
  add(file) {
    this.#becomeFolder();
    this.#create(file, startOf(file));
    this.select(file);
    this.#fire('change');
  }

  /** Removes a pass. Its neighbour is shown. @param {string} file */
  remove(file) {
    const at = this.names.indexOf(file);
    this.#views.get(file).destroy();
    this.#views.delete(file);
    this.#channels = this.channels;
    this.select(this.names[Math.min(at, this.names.length - 1)]);
    this.#fire('change');
  }

  /** Shows a file. @param {string} file */
  select(file) {
    this.#current = file;
    for (const [name, view] of this.#views) view.dom.hidden = name !== file;
    this.view.requestMeasure();
    this.#fire('files');
  }

  /** The editor of a file. @param {string} file */
  editor(file) {
    return this.#views.get(file);
  }

  /** Shows a line of a file, if it is open. @param {string} file @param {number} line */
  reveal(file, line) {
    const view = this.#views.get(file);
    if (!view || line > view.state.doc.lines) return;
    if (file !== this.#current) this.select(file);
    view.dispatch({ effects: EditorView.scrollIntoView(view.state.doc.line(line).from, { y: 'nearest', yMargin: 40 }) });
  }

  /** Shows the file at an address of the language server. Returns its editor. @param {string} uri */
  show(uri) {
    const file = this.names.find((name) => addressOf(name) === uri);
    if (file === undefined) return null;
    if (file !== this.#current) this.select(file);
    return this.view;
  }

  /** Sets what a channel reads; nothing to let the code decide. @param {string} channel @param {string} source */
  setChannel(channel, source) {
    this.#becomeFolder();
    if (source) this.#channels.set(channel, source);
    else this.#channels.delete(channel);
    this.#fire('files');
    this.#fire('change');
  }

  /** The only file becomes the pass that every folder has. */
  #becomeFolder() {
    const [only] = this.#views.keys();
    if (this.#views.size > 1 || only === IMAGE) return;
    const view = this.#views.get(only);
    this.#views.delete(only);
    this.#views.set(IMAGE, view);
    rename(view, IMAGE);
    if (this.#current === only) this.#current = IMAGE;
  }

  /** @param {string} file @param {string} text */
  #create(file, text) {
    this.#views.set(file, openEditor(this.#root, file, text, () => this.#fire('change'), () => this.#fire('breakpoints')));
  }

  /** @param {string} type */
  #fire(type) {
    this.dispatchEvent(new Event(type));
  }
}

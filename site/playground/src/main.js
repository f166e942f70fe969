// The playground: an editor whose language server runs in a worker. Nothing leaves the page.
import { formatDocument } from '@codemirror/lsp-client';
import { startServer } from '../wasm/server.js';
import { client, openEditor, show as showText } from './editor.js';
import { FIRST, examples } from './examples.js';
import { ShaderImage } from './image.js';
import { fragmentOf, textOf } from './link.js';

/** Starts first: nothing else takes as long. */
const server = startServer();

const at = (id) => document.getElementById(id);

/** The findings come first: the module for the image is as large as that for them. */
const found = new Promise((resolve) => { document.addEventListener('findings', resolve, { once: true }); });
found.then(() => performance.mark('first findings'));
const image = new ShaderImage(at('image'), found);

/** Shows a text in the editor, and its image. */
function show(view, name, text) {
  image.restart();
  image.show(name, text);
  showText(view, name, text, (changed) => image.show(name, changed));
}

/** A file name that says what a text is. */
const nameOf = (text) => (text.trimStart().startsWith('{') ? 'shader.json' : 'shader.glsl');

/** Shows what went wrong; nothing without a message. @param {string} [message] */
function warn(message = '') {
  at('notice').textContent = message;
  at('notice').hidden = message === '';
}

/** A short confirmation on a button. */
function confirm(button, word) {
  const { textContent } = button;
  button.textContent = word;
  button.addEventListener('blur', () => { button.textContent = textContent; }, { once: true });
}

async function openLink(view) {
  try {
    const text = await textOf(location.hash);
    warn();
    if (text !== null) show(view, nameOf(text), text);
    return text !== null;
  } catch (error) {
    show(view, 'shader.glsl', '');
    warn(`The link cannot be opened: ${error.message}`);
    return true;
  }
}

function listExamples(view) {
  const groups = Map.groupBy?.(examples, (example) => example.label) ?? new Map([['Examples', examples]]);
  for (const [label, list] of groups) {
    const group = Object.assign(document.createElement('optgroup'), { label });
    for (const example of list) {
      group.append(new Option(example.name, String(examples.indexOf(example))));
    }
    at('examples').append(group);
  }
  at('examples').addEventListener('change', async () => {
    const example = examples[Number(at('examples').value)];
    if (!example) return;
    show(view, example.name, await example.load());
    warn();
    history.replaceState(null, '', location.pathname);
  });
}

async function share(view) {
  const fragment = await fragmentOf(view.state.doc.toString());
  history.replaceState(null, '', fragment);
  try {
    await navigator.clipboard.writeText(location.href);
    confirm(at('share'), 'Copied');
  } catch {
    // Without access to the clipboard the link is in the address bar.
    confirm(at('share'), 'In the address bar');
  }
}

async function fixAll(view) {
  client.sync();
  const [file] = client.workspace.files;
  const end = view.state.doc.lineAt(view.state.doc.length);
  const range = { start: { line: 0, character: 0 }, end: { line: end.number - 1, character: end.length } };
  const context = { diagnostics: [], only: ['source.fixAll.shaderlint'] };
  const actions = await client.request('textDocument/codeAction', { textDocument: { uri: file.uri }, range, context });
  const [edit] = Object.values(actions?.[0]?.edit?.changes ?? {}).flat();
  if (!edit) return confirm(at('fix'), 'Nothing to fix');
  view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: edit.newText }, userEvent: 'input.fix' });
  return undefined;
}

async function start() {
  const view = openEditor(at('code'));
  listExamples(view);
  if (!await openLink(view)) show(view, 'wave.glsl', FIRST);
  addEventListener('hashchange', () => openLink(view));
  at('share').addEventListener('click', () => share(view));
  at('fix').addEventListener('click', () => fixAll(view));
  at('format').addEventListener('click', () => formatDocument(view));
  try {
    client.connect(await server);
  } catch (error) {
    warn(`shaderlint cannot start: ${error.message}`);
  }
}

await start();

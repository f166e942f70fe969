// The playground: editors whose language server runs in a worker. Nothing leaves the page.
import { formatDocument } from '@codemirror/lsp-client';
import { addressIn, filesAt } from './address.js';
import { debugStartIn } from './debug-link.js';
import { Debugger } from './debugger.js';
import { Documents } from './documents.js';
import { addressOf, client } from './editor.js';
import { openExamples } from './examples.js';
import { applyEdits } from './findings.js';
import { FIRST } from './first.js';
import { ShaderImage } from './image.js';
import { Inspector } from './inspect.js';
import { filesOf, fragmentOf } from './link.js';
import { workOffline } from './offline.js';
import { Runner } from './runner.js';
import { server } from './start.js';
import { Tabs } from './tabs.js';
import { offerThemes } from './theme.js';
import { Views } from './views.js';

const at = (id) => document.getElementById(id);

/** The findings come first: the module for the image is as large as that for them. */
const found = new Promise((resolve) => { document.addEventListener('findings', resolve, { once: true }); });
found.then(() => performance.mark('first findings'));
const image = new ShaderImage(at('image'), found);
const documents = new Documents(at('code'));
documents.addEventListener('change', () => image.show(documents.files));
const shader = { image, documents, runner: new Runner() };
const inspector = new Inspector(shader, { button: at('pick'), image: at('image'), panel: at('pixel') });
const debug = new Debugger(shader, { button: at('debug-pixel'), image: at('image'), panel: at('debug'), code: at('code') });
// Both choose a pixel of the same image.
at('pick').addEventListener('click', () => debug.close());
at('debug-pixel').addEventListener('click', () => inspector.close());
const views = new Views(shader, { image: at('image'), select: at('view'), button: at('compare'), status: at('status') });

/**
 * Shows other files in the editor, and their image.
 * @param {import('./passes.js').Files} files
 * @param {import('./debug-link.js').DebugStart} [start] what is debugged
 */
function show(files, start) {
  inspector.close();
  debug.close();
  views.restart();
  image.restart(start);
  documents.open(files);
  image.show(files);
  if (start) debug.openAt(start);
}

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

/** The files at an address. Meanwhile the page can be used. @param {URL} address */
function loaded(address) {
  show({ 'shader.glsl': '' });
  warn(`Loading from ${address.hostname}…`);
  return filesAt(address);
}

/** Opens what the address of the page leads to. Returns whether it leads to anything. */
async function openLink() {
  const { hash } = location;
  // Somebody may have chosen something else in the meantime.
  const isLatest = () => hash === location.hash;
  try {
    const address = addressIn(hash);
    const files = await (address ? loaded(address) : filesOf(hash));
    if (!isLatest()) return true;
    warn();
    if (files) show(files, debugStartIn(hash));
    return files !== null;
  } catch (error) {
    if (!isLatest()) return true;
    show({ 'shader.glsl': '' });
    warn(`The link cannot be opened: ${error.message}`);
    return true;
  }
}

async function share() {
  const fragment = await fragmentOf(documents.files) + debug.words;
  history.replaceState(null, '', fragment);
  try {
    await navigator.clipboard.writeText(location.href);
    confirm(at('share'), 'Copied');
  } catch {
    // Without access to the clipboard the link is in the address bar.
    confirm(at('share'), 'In the address bar');
  }
}

/** Applies the fixes of all files. */
async function fixAll() {
  let isFixed = false;
  for (const name of documents.names) {
    client.sync();
    const uri = addressOf(name);
    const { doc } = client.workspace.getFile(uri);
    const end = doc.line(doc.lines);
    const range = { start: { line: 0, character: 0 }, end: { line: end.number - 1, character: end.length } };
    const context = { diagnostics: [], only: ['source.fixAll.shaderlint'] };
    const actions = await client.request('textDocument/codeAction', { textDocument: { uri }, range, context });
    const action = actions?.find(({ edit }) => edit);
    if (!action) continue;
    applyEdits(client, action);
    isFixed = true;
  }
  if (!isFixed) confirm(at('fix'), 'Nothing to fix');
}

async function connect() {
  try {
    client.connect(await server);
  } catch (error) {
    warn(`shaderlint cannot start: ${error.message}`);
  }
}

async function start() {
  offerThemes(at('theme'));
  new Tabs(at('passes'), at('code'), documents);
  addEventListener('hashchange', openLink);
  at('share').addEventListener('click', share);
  at('fix').addEventListener('click', fixAll);
  at('format').addEventListener('click', () => formatDocument(documents.view));
  openExamples(at('examples'), (files) => {
    history.replaceState(null, '', location.pathname);
    show(files);
    warn();
  });
  connect();
  if (!await openLink()) show({ 'wave.glsl': FIRST });
  await found;
  workOffline();
}

await start();

// The editor: CodeMirror with the language server.
import { indentWithTab } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { shader } from '@codemirror/legacy-modes/mode/clike';
import {
  LSPClient, findReferencesKeymap, formatKeymap, hoverTooltips, jumpToDefinitionKeymap, renameKeymap, serverCompletion,
  signatureHelp,
} from '@codemirror/lsp-client';
import { Compartment, EditorState } from '@codemirror/state';
import { ViewPlugin, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { EditorView, basicSetup } from 'codemirror';
import { breakpoints, changesBreakpoints } from './breakpoints.js';
import controlStyle from './controls.css?inline';
import style from './editor.css?inline';
import findingStyle from './finding.css?inline';
import { findings } from './findings.js';
import { traceMarks } from './trace-marks.js';

/** Milliseconds without typing before the server gets the changes. */
const PAUSE = 50;

/** Sends changes while somebody types. */
const sync = ViewPlugin.fromClass(class {
  update(update) {
    if (!update.docChanged) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => client.sync(), PAUSE);
  }

  destroy() {
    clearTimeout(this.timer);
  }
});

const colors = HighlightStyle.define([
  { tag: tags.comment, class: 'hl-comment' },
  { tag: tags.keyword, class: 'hl-keyword' },
  { tag: [tags.typeName, tags.standard(tags.typeName)], class: 'hl-type' },
  { tag: [tags.number, tags.bool, tags.atom], class: 'hl-number' },
  { tag: [tags.processingInstruction, tags.meta], class: 'hl-directive' },
  { tag: tags.standard(tags.variableName), class: 'hl-function' },
]);

/** The client of the language server. */
export const client = new LSPClient({
  timeout: 10_000,
  initializationOptions: { site: new URL('../', location.href).href },
  extensions: [
    serverCompletion(), hoverTooltips(), signatureHelp(), findings, sync,
    keymap.of([...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap]),
  ],
});

/** What every document has. */
const common = [
  breakpoints,
  basicSetup,
  StreamLanguage.define(shader),
  syntaxHighlighting(colors),
  indentUnit.of('    '),
  keymap.of([indentWithTab]),
  traceMarks,
  EditorView.contentAttributes.of({ 'aria-label': 'Shader code', tabindex: '0' }),
];

/**
 * The place for editors in an element. They lie in a shadow root: there their styles are objects, while the
 * page's policy forbids style elements.
 * @param {HTMLElement} parent
 */
export function editorRoot(parent) {
  const root = parent.attachShadow({ mode: 'open' });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(controlStyle + style + findingStyle);
  root.adoptedStyleSheets = [sheet];
  return root;
}

/** The connection of an editor to the language server, under a name that may change. */
const connection = new Compartment();

/** The document of a file for the language server. @param {string} file */
const document = (file) => client.plugin(addressOf(file), file.endsWith('.html') ? 'html' : 'glsl');

/** The address of a file for the language server: all lie in one folder. @param {string} file */
export const addressOf = (file) => `file:///${encodeURIComponent(file)}`;

/**
 * Opens an editor of a file.
 * @param {ShadowRoot} root
 * @param {string} file
 * @param {string} text
 * @param {() => void} changed is called after each change
 * @param {() => void} marked is called after each change of breakpoints
 */
export function openEditor(root, file, text, changed, marked) {
  const follow = EditorView.updateListener.of((update) => {
    if (update.docChanged) changed();
    if (changesBreakpoints(update)) marked();
  });
  const state = EditorState.create({ doc: text, extensions: [common, follow, connection.of(document(file))] });
  return new EditorView({ state, parent: root, root });
}

/** Gives the file of an editor another name. @param {EditorView} view @param {string} file */
export const rename = (view, file) => view.dispatch({ effects: connection.reconfigure(document(file)) });

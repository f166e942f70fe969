// The editor: CodeMirror with the language server.
import { indentWithTab } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { shader } from '@codemirror/legacy-modes/mode/clike';
import {
  LSPClient, findReferencesKeymap, formatKeymap, hoverTooltips, jumpToDefinitionKeymap, renameKeymap, serverCompletion,
  signatureHelp,
} from '@codemirror/lsp-client';
import { EditorState } from '@codemirror/state';
import { ViewPlugin, keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { EditorView, basicSetup } from 'codemirror';
import style from './editor.css?inline';
import findingStyle from './finding.css?inline';
import { findings } from './findings.js';

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
  basicSetup,
  StreamLanguage.define(shader),
  syntaxHighlighting(colors),
  indentUnit.of('    '),
  keymap.of([indentWithTab]),
  EditorView.contentAttributes.of({ 'aria-label': 'Shader code', tabindex: '0' }),
];

/**
 * Opens an editor in an element. It lies in a shadow root: there its styles are objects, while the page's
 * policy forbids style elements.
 */
export function openEditor(parent) {
  const root = parent.attachShadow({ mode: 'open' });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style + findingStyle);
  root.adoptedStyleSheets = [sheet];
  return new EditorView({ parent: root, root });
}

/** Shows a text as a new document. `changed` is called with each new text. */
export function show(view, name, text, changed) {
  const follow = EditorView.updateListener.of((update) => {
    if (update.docChanged) changed(update.state.doc.toString());
  });
  const extensions = [common, follow, client.plugin(`file:///${encodeURIComponent(name)}`, 'glsl')];
  view.setState(EditorState.create({ doc: text, extensions }));
}

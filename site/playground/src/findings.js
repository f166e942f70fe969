// The findings of the language server: marks in the editors, and one list of all beside them.
import { setDiagnostics } from '@codemirror/lint';
import { element } from './element.js';
import { positionOf, titleOf } from './passes.js';
import { pluginOf } from './plugin.js';

const SEVERITIES = { 1: 'error', 2: 'warning', 3: 'info', 4: 'info' };
const NAMES = { error: ['error', 'errors'], warning: ['warning', 'warnings'], info: ['info', 'infos'] };

/** The findings and their entries in the list, by address of the document. @type {Map<string, { severities: string[], entries: Element[] }>} */
const all = new Map();

/** A message with the code in it as elements. @param {string} message */
const withCode = (message) => message.split('`').map((part, i) => (i % 2 ? element('code', { textContent: part }) : part));

/** The file of an address. @param {string} uri */
const fileOf = (uri) => decodeURIComponent(uri.slice('file:///'.length));

/** Applies the edits of a code action to the documents that it is about. */
export function applyEdits(client, action) {
  for (const [uri, edits] of Object.entries(action.edit?.changes ?? {})) {
    const plugin = pluginOf(client, uri);
    const changes = edits.map(({ range, newText }) => ({
      from: plugin.fromPosition(range.start),
      to: plugin.fromPosition(range.end),
      insert: newText,
    }));
    plugin.view.dispatch({ changes, userEvent: 'input.fix' });
  }
}

/** The fixes of a finding, as buttons. */
async function addFixes(plugin, finding, into) {
  plugin.client.sync();
  const params = {
    textDocument: { uri: plugin.uri },
    range: finding.range,
    context: { diagnostics: [finding], only: ['quickfix'] },
  };
  const actions = (await plugin.client.request('textDocument/codeAction', params)) ?? [];
  for (const action of actions.filter((offered) => offered.edit)) {
    const apply = () => {
      applyEdits(plugin.client, action);
      plugin.client.workspace.displayFile(plugin.uri).then((view) => view.focus());
    };
    into.append(element('button', { type: 'button', onclick: apply }, ...withCode(action.title)));
  }
}

/** A finding with its reason, its page and its fixes. */
function described(plugin, finding) {
  const [title, ...notes] = finding.message.split('\n');
  const page = finding.codeDescription?.href;
  const name = page
    ? element('a', { href: page, textContent: finding.code, target: '_blank', rel: 'noopener' })
    : element('span', { textContent: finding.code });
  const fixes = element('span', { className: 'fixes' });
  const severity = SEVERITIES[finding.severity];
  const made = element('div', { className: `finding ${severity}` });
  made.append(element('p', {}, element('b', { textContent: severity }), ' ', ...withCode(title)), element('small', {}, name));
  made.append(...notes.map((note) => element('p', { className: 'note' }, ...withCode(note))), fixes);
  addFixes(plugin, finding, fixes).catch(() => {});
  return made;
}

/** An entry of the list. A click on its place goes there. */
function entry(plugin, finding) {
  const line = finding.range.start.line + 1;
  const go = async () => {
    const view = await plugin.client.workspace.displayFile(plugin.uri);
    const at = plugin.fromPosition(finding.range.start);
    view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
    view.focus();
  };
  const place = element('button', { type: 'button', className: 'place', onclick: go });
  place.append(element('span', { className: 'pass', textContent: `${titleOf(fileOf(plugin.uri))} · ` }), `Line ${line}`);
  return element('li', {}, place, described(plugin, finding));
}

/** Shows the findings of all documents, in the order of their tabs. */
function list() {
  const documents = [...all].sort(([a], [b]) => positionOf(fileOf(a)) - positionOf(fileOf(b))).map(([, found]) => found);
  const severities = documents.flatMap((found) => found.severities);
  const counts = Object.entries(NAMES).map(([severity, [one, several]]) => {
    const count = severities.filter((own) => own === severity).length;
    return count === 0 ? '' : `${count} ${count === 1 ? one : several}`;
  });
  const items = document.querySelector('#list');
  document.querySelector('#summary').textContent = counts.filter(Boolean).join(', ') || 'No findings';
  items.classList.toggle('several', all.size > 1);
  items.replaceChildren(...documents.flatMap((found) => found.entries));
}

/** Handles the findings that the server publishes. */
export const findings = {
  clientCapabilities: {
    textDocument: {
      publishDiagnostics: { versionSupport: true, codeDescriptionSupport: true },
      // The client announces that it asks for findings, but does not.
      diagnostic: false,
    },
  },
  notificationHandlers: {
    'textDocument/publishDiagnostics': (client, params) => {
      const file = client.workspace.getFile(params.uri);
      const plugin = pluginOf(client, params.uri);
      // A document that was closed has no version. Another one may be open under its name.
      const isClosed = (params.version ?? null) === null;
      if (isClosed && !file) {
        all.delete(params.uri);
        list();
      }
      if (isClosed) return true;
      if (!plugin || params.version !== file.version) return false;
      const at = (position) => plugin.unsyncedChanges.mapPos(plugin.fromPosition(position, plugin.syncedDoc));
      const marks = params.diagnostics.map((finding) => ({
        from: at(finding.range.start),
        to: at(finding.range.end),
        severity: SEVERITIES[finding.severity],
        message: finding.message,
        renderMessage: () => described(plugin, finding),
      }));
      plugin.view.dispatch(setDiagnostics(plugin.view.state, marks));
      all.set(params.uri, {
        severities: params.diagnostics.map(({ severity }) => SEVERITIES[severity]),
        entries: params.diagnostics.map((finding) => entry(plugin, finding)),
      });
      list();
      document.dispatchEvent(new Event('findings'));
      return true;
    },
  },
};

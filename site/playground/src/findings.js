// The findings of the language server: marks in the editor, and the list beside it.
import { setDiagnostics } from '@codemirror/lint';
import { LSPPlugin } from '@codemirror/lsp-client';

const SEVERITIES = { 1: 'error', 2: 'warning', 3: 'info', 4: 'info' };
const NAMES = { error: ['error', 'errors'], warning: ['warning', 'warnings'], info: ['info', 'infos'] };

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** A message with the code in it as elements. @param {string} message */
const withCode = (message) => message.split('`').map((part, i) => (i % 2 ? element('code', { textContent: part }) : part));

/** Applies the edits of a code action to the document of an editor. */
function apply(plugin, action) {
  const edits = Object.values(action.edit?.changes ?? {}).flat();
  const changes = edits.map(({ range, newText }) => ({
    from: plugin.fromPosition(range.start),
    to: plugin.fromPosition(range.end),
    insert: newText,
  }));
  plugin.view.dispatch({ changes, userEvent: 'input.fix' });
  plugin.view.focus();
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
    into.append(element('button', { type: 'button', onclick: () => apply(plugin, action) }, ...withCode(action.title)));
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

/** Shows findings in the list. Returns nothing; a click goes to the place. */
function list(plugin, findings) {
  const counts = Object.entries(NAMES).map(([severity, [one, several]]) => {
    const count = findings.filter((finding) => SEVERITIES[finding.severity] === severity).length;
    return count === 0 ? '' : `${count} ${count === 1 ? one : several}`;
  });
  const summary = counts.filter(Boolean).join(', ');
  document.querySelector('#summary').textContent = summary || 'No findings';
  const items = findings.map((finding) => {
    const line = finding.range.start.line + 1;
    const go = () => {
      const at = plugin.fromPosition(finding.range.start);
      plugin.view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
      plugin.view.focus();
    };
    const place = element('button', { type: 'button', className: 'place', textContent: `Line ${line}`, onclick: go });
    return element('li', {}, place, described(plugin, finding));
  });
  document.querySelector('#list').replaceChildren(...items);
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
      const view = file?.getView();
      const plugin = view && LSPPlugin.get(view);
      if (!plugin || (params.version ?? file.version) !== file.version) return false;
      const at = (position) => plugin.unsyncedChanges.mapPos(plugin.fromPosition(position, plugin.syncedDoc));
      const marks = params.diagnostics.map((finding) => ({
        from: at(finding.range.start),
        to: at(finding.range.end),
        severity: SEVERITIES[finding.severity],
        message: finding.message,
        renderMessage: () => described(plugin, finding),
      }));
      view.dispatch(setDiagnostics(view.state, marks));
      list(plugin, params.diagnostics);
      document.dispatchEvent(new Event('findings'));
      return true;
    },
  },
};

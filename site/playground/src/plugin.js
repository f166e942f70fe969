import { LSPPlugin } from '@codemirror/lsp-client';

/** The connection of an editor to the language server, by the address of its document; null if none is open. */
export function pluginOf(client, uri) {
  const view = client.workspace.getFile(uri)?.getView();
  return view ? LSPPlugin.get(view) : null;
}

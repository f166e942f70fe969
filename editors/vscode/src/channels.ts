// The file that says what the channels of a shader read.
import * as vscode from 'vscode';
import type { BaseLanguageClient } from 'vscode-languageclient';

/** Where the file is, as the server returns it. */
export interface ChannelFile {
    uri: string;
    exists: boolean;
}

/** Lets the server write the file of a document's shader, or opens the one that exists, beside the document. */
export async function openChannels(client: BaseLanguageClient, document: vscode.Uri, shader: number | undefined, file: ChannelFile): Promise<void> {
    const uri = client.protocol2CodeConverter.asUri(file.uri);
    if (!file.exists) {
        const written = new Promise<vscode.TextDocument>((resolve) => {
            const listener = vscode.workspace.onDidChangeTextDocument((change) => {
                if (change.document.uri.toString() !== uri.toString()) return;
                listener.dispose();
                resolve(change.document);
            });
        });
        const given = [client.code2ProtocolConverter.asUri(document), shader ?? null];
        await client.sendRequest('workspace/executeCommand', { command: 'shaderlint.writeChannels', arguments: given });
        // The server reads the file from the disk.
        await (await written).save();
    }
    const editor = vscode.window.visibleTextEditors.find((other) => other.document.uri.toString() === document.toString());
    await vscode.window.showTextDocument(uri, { viewColumn: editor?.viewColumn ?? vscode.ViewColumn.One, preview: false });
}

/** Calls a function when such a file changes. */
export function onChannels(act: () => void): vscode.Disposable {
    const watcher = vscode.workspace.createFileSystemWatcher('**/*channels.toml');
    for (const event of [watcher.onDidChange, watcher.onDidCreate, watcher.onDidDelete]) event(act);
    return watcher;
}

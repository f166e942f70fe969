// The extension where no program can be started: the server is a WebAssembly module in a worker, which is sent
// the files of the workspace.
import * as vscode from 'vscode';
import { LanguageClient, type LanguageClientOptions } from 'vscode-languageclient/browser';
import { type Server, startServer } from '../../../src/wasm/js/server.js';
import { activateIn } from './extension';
import { fromServer, toServer, WorkspaceFiles } from './files';
import { SECTION } from './settings';

export { deactivate } from './extension';

/** A client that only logs its errors: the messages of the extension tell the user, once. */
class QuietClient extends LanguageClient {
    constructor(options: LanguageClientOptions, private readonly port: ServerPort) {
        // The client only posts messages to a worker, and listens to it.
        super(SECTION, 'shaderlint', options, port as unknown as Worker);
    }

    override error(message: string, data?: unknown): void {
        super.error(message, data, false);
    }

    override async dispose(timeout?: number): Promise<void> {
        try {
            await super.dispose(timeout);
        } finally {
            this.port.terminate();
        }
    }
}

/** A server with the interface of a worker. */
class ServerPort {
    onmessage: ((event: { data: unknown }) => void) | undefined;

    constructor(private readonly server: Server) {
        server.subscribe((text) => this.onmessage?.({ data: JSON.parse(text) }));
    }

    postMessage(message: unknown): void {
        this.server.send(JSON.stringify(message));
    }

    // The server replaces a worker that fails.
    addEventListener(): void {}

    terminate(): void {
        this.server.close();
    }
}

export function activate(context: vscode.ExtensionContext): Promise<void> {
    const read = async (name: string): Promise<Uint8Array<ArrayBuffer>> => {
        const bytes = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(context.extensionUri, 'dist', name));
        return bytes as Uint8Array<ArrayBuffer>;
    };
    const files = new WorkspaceFiles();
    return activateIn({
        async createClient(options) {
            const [bytes, script, sent] = await Promise.all([
                read('shaderport.wasm'), read('worker.js'), files.read(),
            ]);
            // Not every host can start a worker from a file of an extension.
            const address = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
            const server = await startServer({ source: bytes, worker: () => new Worker(address) });
            const initial = options.initializationOptions as object;
            const client = new QuietClient({
                ...options,
                initializationOptions: { ...initial, files: sent },
                uriConverters: { code2Protocol: toServer, protocol2Code: fromServer },
                middleware: {
                    ...options.middleware,
                    // The server cannot read the files; they are sent with their texts.
                    workspace: { ...options.middleware?.workspace, didChangeWatchedFile: () => Promise.resolve() },
                },
            }, new ServerPort(server));
            files.follow((changed) => {
                client.sendNotification('shaderlint/files', { files: changed }).catch(() => {
                    // It was stopped; the next one is sent all files.
                });
            });
            return client;
        },
        doubt: () => 'The WebAssembly module does not respond.',
        extend: () => [files],
        startSettings: ['exports'],
    }, context);
}

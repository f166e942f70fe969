// Starts the language server, and adds the views that the protocol does not have. `node.ts` and `browser.ts`
// say what the server is.
import * as vscode from 'vscode';
import {
    type BaseLanguageClient, CloseAction, ErrorAction, type LanguageClientOptions, type Position, type Range,
} from 'vscode-languageclient';
import { LineCosts } from './lineCosts';
import { Previews } from './preview';
import { renameAt } from './rename';
import { documentSelector, PREVIEW_COMMAND, RENAME_COMMAND, SECTION, serverSettings } from './settings';
import { tune } from './tune';

/** Where the extension runs. */
export interface Host {
    /** Creates a client of a server that has not started yet. */
    createClient(options: LanguageClientOptions): Promise<BaseLanguageClient>;
    /** What may be wrong with a server that does not answer. */
    doubt(): string;
    /** Adds what only this host can do. */
    extend(previews: Previews): { dispose(): unknown }[];
    /** Names of the settings that are read when the server starts. */
    readonly startSettings: readonly string[];
}

let client: BaseLanguageClient | undefined;
/** Whether the server has ever answered: one that has not is not restarted. */
let hasStarted = false;
/** The last start or stop: each one waits for the one before it. */
let last: Promise<void> = Promise.resolve();

export async function activateIn(host: Host, context: vscode.ExtensionContext): Promise<void> {
    const output = vscode.window.createOutputChannel('shaderlint');
    const restart = (): Promise<void> => {
        last = last.then(async () => {
            await stop();
            await start(host, output);
            previews.renew();
            costs.renewSoon();
        });
        return last;
    };
    const previews = new Previews(context, () => client);
    const costs = new LineCosts(() => client);
    context.subscriptions.push(
        output,
        previews,
        costs,
        ...host.extend(previews),
        vscode.commands.registerCommand('shaderlint.restart', restart),
        vscode.commands.registerCommand(PREVIEW_COMMAND, (place?: unknown, shader?: unknown) =>
            previews.open(typeof place === 'string' ? addressOf(place) : place, shader)),
        vscode.commands.registerCommand('shaderlint.previewValue', () => previews.openValue()),
        vscode.commands.registerCommand('shaderlint.toggleLineCosts', () => costs.toggle()),
        vscode.commands.registerCommand('shaderlint.tune', (uri: string, range: Range, value: number, min: number, max: number) =>
            tune(addressOf(uri), range, value, min, max)),
        vscode.commands.registerCommand(RENAME_COMMAND, (uri: string, at: Position) => renameAt(addressOf(uri), at)),
        vscode.workspace.onDidChangeConfiguration((change) => {
            const restarts = host.startSettings.some((name) => change.affectsConfiguration(`${SECTION}.${name}`));
            if (restarts) void restart();
            else if (change.affectsConfiguration(SECTION)) tellSettings();
        }),
        vscode.workspace.onDidGrantWorkspaceTrust(() => void restart()),
    );
    await restart();
}

export async function deactivate(): Promise<void> {
    await last;
    await stop();
}

/** The address of a document that the server names in the arguments of a command. */
function addressOf(uri: string): vscode.Uri {
    return client ? client.protocol2CodeConverter.asUri(uri) : vscode.Uri.parse(uri);
}

async function start(host: Host, output: vscode.OutputChannel): Promise<void> {
    hasStarted = false;
    try {
        client = await host.createClient(clientOptions(output));
        await client.start().catch((error: unknown) => {
            throw new Error(`${host.doubt()} (${String(error)})`);
        });
        hasStarted = true;
    } catch (error) {
        client = undefined;
        output.appendLine(String(error));
        void offerSetting(error instanceof Error ? error.message : String(error), host);
    }
}

function clientOptions(output: vscode.OutputChannel): LanguageClientOptions {
    return {
        documentSelector: documentSelector(),
        initializationOptions: serverSettings(),
        outputChannel: output,
        markdown: { isTrusted: false, supportHtml: false },
        middleware: {
            workspace: {
                // The server asks for the whole section, which lacks the names of commands.
                configuration: async (params, token, next) => {
                    const told: unknown = await next(params, token);
                    if (!Array.isArray(told)) return [];
                    return params.items.map((item, i): unknown =>
                        item.section === SECTION ? serverSettings() : told[i]);
                },
            },
        },
        // The one message below says what is wrong.
        initializationFailedHandler: () => false,
        errorHandler: {
            error: () => ({ action: ErrorAction.Continue, handled: true }),
            closed: restartsWhileItHelps(output),
        },
    };
}

async function stop(): Promise<void> {
    const old = client;
    client = undefined;
    try {
        await old?.dispose();
    } catch {
        // A crashed server cannot be stopped.
    }
}

/** Restarts a server that stops, unless it keeps stopping. */
function restartsWhileItHelps(output: vscode.OutputChannel): () => { action: CloseAction; handled: boolean } {
    const ends: number[] = [];
    return () => {
        if (!hasStarted) return { action: CloseAction.DoNotRestart, handled: true };
        ends.push(Date.now());
        const recent = ends.slice(-4);
        const isHopeless = recent.length === 4 && (recent[3] ?? 0) - (recent[0] ?? 0) < 180_000;
        if (!isHopeless) return { action: CloseAction.Restart, handled: true };
        output.appendLine('The language server stopped four times within three minutes.');
        void offerRestart(output);
        return { action: CloseAction.DoNotRestart, handled: true };
    };
}

async function offerRestart(output: vscode.OutputChannel): Promise<void> {
    const told = 'shaderlint stopped several times in a row and was not restarted.';
    const chosen = await vscode.window.showErrorMessage(told, 'Restart', 'Show Output');
    if (chosen === 'Restart') await vscode.commands.executeCommand('shaderlint.restart');
    else if (chosen) output.show();
}

async function offerSetting(why: string, host: Host): Promise<void> {
    const settings = host.startSettings.includes('path') ? ['Open Settings'] : [];
    const chosen = await vscode.window.showErrorMessage(`Could not start the shaderlint language server: ${why}`, ...settings);
    if (chosen) await vscode.commands.executeCommand('workbench.action.openSettings', 'shaderlint.path');
}

function tellSettings(): void {
    if (!client?.isRunning()) return;
    void client.sendNotification('workspace/didChangeConfiguration', { settings: { [SECTION]: serverSettings() } });
}

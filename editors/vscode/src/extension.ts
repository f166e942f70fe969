// Starts the language server, and adds the views that the protocol does not have.
import * as vscode from 'vscode';
import { CloseAction, ErrorAction, LanguageClient, type LanguageClientOptions } from 'vscode-languageclient/node';
import { binary } from './binary';
import { CostMaps } from './costMap';
import { LineCosts } from './lineCosts';
import { Previews } from './preview';
import { renameAt } from './rename';
import { documentSelector, PREVIEW_COMMAND, RENAME_COMMAND, SECTION, serverSettings } from './settings';
import { tune } from './tune';

/** A client that only logs its errors: the messages below tell the user, once. */
class QuietClient extends LanguageClient {
    override error(message: string, data?: unknown): void {
        super.error(message, data, false);
    }
}

let client: LanguageClient | undefined;
/** Whether the server has ever answered: one that has not is not restarted. */
let hasStarted = false;
/** The last start or stop: each one waits for the one before it. */
let last: Promise<void> = Promise.resolve();

export async function activate(context: vscode.ExtensionContext): Promise<void> {
    const output = vscode.window.createOutputChannel('shaderlint');
    const restart = (): Promise<void> => {
        last = last.then(async () => {
            await stop();
            await start(context, output);
            previews.renew();
            costs.renewSoon();
        });
        return last;
    };
    const previews = new Previews(context, () => client);
    const costs = new LineCosts(() => client);
    const maps = new CostMaps(() => binary(context), previews);
    context.subscriptions.push(
        output,
        previews,
        costs,
        maps,
        vscode.commands.registerCommand('shaderlint.restart', restart),
        vscode.commands.registerCommand(PREVIEW_COMMAND, (place?: unknown, shader?: unknown) => previews.open(place, shader)),
        vscode.commands.registerCommand('shaderlint.costMap', (place?: unknown) => maps.show(place)),
        vscode.commands.registerCommand('shaderlint.previewValue', () => previews.openValue()),
        vscode.commands.registerCommand('shaderlint.toggleLineCosts', () => costs.toggle()),
        vscode.commands.registerCommand('shaderlint.tune', tune),
        vscode.commands.registerCommand(RENAME_COMMAND, renameAt),
        vscode.workspace.onDidChangeConfiguration((change) => {
            const restarts = ['path', 'exports'].some((name) => change.affectsConfiguration(`${SECTION}.${name}`));
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

async function start(context: vscode.ExtensionContext, output: vscode.OutputChannel): Promise<void> {
    hasStarted = false;
    try {
        const command = binary(context);
        client = createClient(command, output);
        await client.start().catch((error: unknown) => {
            throw new Error(`\`${command} lsp\` does not respond. The program may be damaged or too old. (${String(error)})`);
        });
        hasStarted = true;
    } catch (error) {
        client = undefined;
        output.appendLine(String(error));
        void offerSetting(error instanceof Error ? error.message : String(error));
    }
}

function createClient(command: string, output: vscode.OutputChannel): LanguageClient {
    const options: LanguageClientOptions = {
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
    const server = { command, args: ['lsp'] };
    return new QuietClient(SECTION, 'shaderlint', { run: server, debug: server }, options);
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

async function offerSetting(why: string): Promise<void> {
    const chosen = await vscode.window.showErrorMessage(`Could not start the shaderlint language server: ${why}`, 'Open Settings');
    if (chosen) await vscode.commands.executeCommand('workbench.action.openSettings', 'shaderlint.path');
}

function tellSettings(): void {
    if (!client?.isRunning()) return;
    void client.sendNotification('workspace/didChangeConfiguration', { settings: { [SECTION]: serverSettings() } });
}

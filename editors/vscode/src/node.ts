// The extension where programs can be started: the server is `shaderlint lsp`.
import * as vscode from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';
import { binary } from './binary';
import { CostMaps } from './costMap';
import { activateDebugger, debugPixel } from './debug/debugger';
import { activateIn } from './extension';
import { SECTION } from './settings';

export { deactivate } from './extension';

/** A client that only logs its errors: the messages of the extension tell the user, once. */
class QuietClient extends LanguageClient {
    override error(message: string, data?: unknown): void {
        super.error(message, data, false);
    }
}

export function activate(context: vscode.ExtensionContext): Promise<void> {
    let command = '';
    void vscode.commands.executeCommand('setContext', 'shaderlint.hasProgram', true);
    return activateIn({
        createClient(options) {
            command = binary(context);
            const server = { command, args: ['lsp'] };
            return Promise.resolve(new QuietClient(SECTION, 'shaderlint', { run: server, debug: server }, options));
        },
        doubt: () => `\`${command} lsp\` does not respond. The program may be damaged or too old.`,
        extend(previews) {
            const maps = new CostMaps(() => binary(context), previews);
            previews.debugPixel = (uri, shown) => void debugPixel(uri, shown);
            return [
                maps,
                ...activateDebugger(context, () => binary(context)),
                vscode.commands.registerCommand('shaderlint.debug.previewPixel', () => previews.pickPixel()),
                vscode.commands.registerCommand('shaderlint.costMap', (place?: unknown) => maps.show(place)),
            ];
        },
        startSettings: ['path', 'exports'],
    }, context);
}

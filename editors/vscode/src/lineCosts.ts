// The share of each line in the cost of its shader, in the gutter and the scroll bar.
import * as vscode from 'vscode';
import type { BaseLanguageClient } from 'vscode-languageclient';
import { documentSelector, SECTION } from './settings';

/** Shares below this are not shown, in percent. */
const LEAST = 5;
/** Shaders with fewer operations have no lines worth a look. */
const CHEAP = 50;
/** The delay between the last change and the request for new costs, in milliseconds. */
const PAUSE = 500;
const SETTING = 'lineCosts';

/** The cost of a shader, as the server returns it. */
interface ShaderCosts {
    per: 'pixel' | 'vertex';
    operations: number;
    source: 'sampleRun' | 'bound' | 'estimate';
    lines: { line: number; operations: number; share: number }[];
}

/** Shows costs in all visible editors. */
export class LineCosts implements vscode.Disposable {
    /** By percentage. */
    private readonly types = new Map<number, vscode.TextEditorDecorationType>();
    private readonly subscriptions: vscode.Disposable[];
    private timer: ReturnType<typeof setTimeout> | undefined;
    private asked = new vscode.CancellationTokenSource();

    constructor(private readonly client: () => BaseLanguageClient | undefined) {
        this.subscriptions = [
            vscode.window.onDidChangeVisibleTextEditors(() => { this.renewSoon(); }),
            // Another document may be included.
            vscode.workspace.onDidChangeTextDocument(({ contentChanges }) => {
                if (contentChanges.length > 0) this.renewSoon();
            }),
            vscode.workspace.onDidChangeConfiguration((change) => {
                if (change.affectsConfiguration(SECTION)) this.renewSoon();
            }),
            vscode.debug.onDidChangeActiveDebugSession(() => { this.renewSoon(); }),
        ];
    }

    /** Changes the setting. */
    async toggle(): Promise<void> {
        const settings = vscode.workspace.getConfiguration(SECTION);
        await settings.update(SETTING, !isOn(), vscode.ConfigurationTarget.Global);
    }

    /** Requests all costs when changes pause. */
    renewSoon(): void {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => void this.renew(), PAUSE);
    }

    dispose(): void {
        clearTimeout(this.timer);
        this.asked.cancel();
        for (const type of this.types.values()) type.dispose();
        for (const subscription of this.subscriptions) subscription.dispose();
    }

    private async renew(): Promise<void> {
        this.asked.cancel();
        const asked = new vscode.CancellationTokenSource();
        this.asked = asked;
        for (const editor of vscode.window.visibleTextEditors) {
            const costs = await this.costsOf(editor.document, asked.token).catch(() => undefined);
            if (asked.token.isCancellationRequested) return;
            // Without an answer, the old costs stay.
            if (costs) this.show(editor, costs);
        }
    }

    private async costsOf(document: vscode.TextDocument, token: vscode.CancellationToken): Promise<ShaderCosts[] | undefined> {
        const isShader = vscode.languages.match(documentSelector(), document) > 0 && document.languageId !== 'json';
        const client = this.client();
        // The editor sets no breakpoint by a click on a number.
        if (!isOn() || !isShader || vscode.debug.activeDebugSession) return [];
        if (!client) return undefined;
        const params = { textDocument: { uri: client.code2ProtocolConverter.asUri(document.uri) } };
        return client.sendRequest<ShaderCosts[]>('shaderlint/costs', params, token);
    }

    private show(editor: vscode.TextEditor, costs: ShaderCosts[]): void {
        const shown = new Map<number, vscode.DecorationOptions[]>();
        for (const shader of costs.filter(({ operations }) => operations >= CHEAP)) {
            for (const { line, operations, share } of shader.lines) {
                const percent = Math.round(share * 100);
                if (percent < LEAST || line >= editor.document.lineCount) continue;
                // At the end, so that hovers over the code stay as they are.
                const end = editor.document.lineAt(line).range.end;
                const range = new vscode.Range(end, end);
                const options = { range, hoverMessage: words(shader, operations, percent) };
                shown.set(percent, [...shown.get(percent) ?? [], options]);
            }
        }
        for (const percent of shown.keys()) this.typeOf(percent);
        for (const [percent, type] of this.types) editor.setDecorations(type, shown.get(percent) ?? []);
    }

    private typeOf(percent: number): vscode.TextEditorDecorationType {
        const known = this.types.get(percent);
        if (known) return known;
        const icon = (color: string): { gutterIconPath: vscode.Uri } => ({ gutterIconPath: number(percent, color) });
        const type = vscode.window.createTextEditorDecorationType({
            gutterIconSize: 'contain',
            light: icon('#333333'),
            dark: icon('#e0e0e0'),
            overviewRulerColor: heat(percent),
            overviewRulerLane: vscode.OverviewRulerLane.Left,
        });
        this.types.set(percent, type);
        return type;
    }
}

function isOn(): boolean {
    return vscode.workspace.getConfiguration(SECTION).get<boolean>(SETTING, true);
}

/** Orange, more opaque for a larger share. */
function heat(percent: number): string {
    return `rgba(232, 112, 32, ${(0.12 + percent / 150).toFixed(2)})`;
}

/** A percentage as an image. */
function number(percent: number, color: string): vscode.Uri {
    const size = percent < 100 ? 11 : 8.5;
    const image = '<svg xmlns="http://www.w3.org/2000/svg" width="18" height="18">'
        + `<rect x="1" y="2" width="16" height="14" rx="2" fill="${heat(percent)}"/>`
        + `<text x="9" y="13" font-family="sans-serif" font-size="${size}" text-anchor="middle" fill="${color}">${percent}</text>`
        + '</svg>';
    return vscode.Uri.parse(`data:image/svg+xml,${encodeURIComponent(image)}`);
}

function words({ per, operations: all, source }: ShaderCosts, operations: number, percent: number): string {
    const count = (value: number): string => Math.round(value).toLocaleString('en');
    const from = source === 'sampleRun' ? 'sample run' : 'estimated';
    return `${percent} % of the cost: ${count(operations)} of ${count(all)} operations per ${per} (${from})`;
}

// The preview of a shader next to its editor. The server creates the page; `media/preview.js` shows it,
// and transfers the state of the player from one page to the next.
import * as vscode from 'vscode';
import { type BaseLanguageClient, ErrorCodes, RequestType, ResponseError } from 'vscode-languageclient';
import { type ChannelFile, onChannels, openChannels } from './channels';
import type { ShownPixel } from './debug/debugger';
import { isRange, ShownValue } from './shownValue';

const VIEW = 'shaderlint.preview';
/** The delay between the last change and the request for a new page, in milliseconds. */
const PAUSE = 300;

/** The shader at a position, or the one with this number in its document, or a value in it. */
interface Shown {
    position?: { line: number; character: number };
    shader?: number;
    value?: ShownValue;
}

/** A page, as the server returns it. */
interface Page {
    html: string;
    shader: number;
    /** The shown value, and the numbers that are shown as 0 and 1. */
    value: { text: string; limits: [number, number] } | null;
    /** The channels that nothing gives an input. */
    assumed: { pass: string; channel: string; shows: string }[];
    /** The file that gives inputs. */
    channels: ChannelFile | null;
}

const PAGE = new RequestType<object, Page, void>('shaderlint/page');

/** Messages from the view. */
type Told =
    | { type: 'ready' }
    | { type: 'time'; time: number }
    | { type: 'channels' }
    | { type: 'colour' }
    | { type: 'pixel'; shown: ShownPixel }
    | { type: 'write'; numbers: { name: string; text: string }[] };

/** All previews, one for each document. */
export class Previews implements vscode.Disposable, vscode.WebviewPanelSerializer {
    /** Debugs a pixel of a document, where that is possible. */
    debugPixel: ((uri: vscode.Uri, shown: ShownPixel) => void) | undefined;
    private readonly previews = new Map<string, Preview>();
    private readonly subscriptions: vscode.Disposable[];

    constructor(
        private readonly context: vscode.ExtensionContext,
        private readonly client: () => BaseLanguageClient | undefined,
    ) {
        this.subscriptions = [
            vscode.window.registerWebviewPanelSerializer(VIEW, this),
            // Other documents may be passes or includes of the shader.
            vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
                if (contentChanges.length === 0) return;
                for (const [uri, preview] of this.previews) {
                    if (document.uri.toString() === uri) preview.follow(contentChanges);
                    if (document.languageId === 'glsl' || document.uri.toString() === uri) preview.renewSoon();
                }
            }),
            onChannels(() => { this.renew(); }),
        ];
    }

    /** Opens a preview of the selected value. */
    async openValue(): Promise<void> {
        const editor = vscode.window.activeTextEditor;
        if (editor) await this.open(editor.document.uri, editor.selection);
    }

    /**
     * Opens a preview of the document at `place`, or else of the active editor's: of the shader with
     * this number or of the value in this range, or else of the shader under the cursor.
     */
    async open(place: unknown, shader: unknown): Promise<void> {
        const uri = uriOf(place);
        if (!uri) {
            void vscode.window.showInformationMessage('Open a shader first to preview it.');
            return;
        }
        const known = this.previews.get(uri.toString());
        const shown = typeof shader === 'number' ? { shader }
            : isRange(shader) ? { value: await ShownValue.of(uri, shader) }
            : cursor(uri);
        if (known) {
            known.show(shown);
            known.panel.reveal(undefined, true);
            return;
        }
        const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
        const panel = vscode.window.createWebviewPanel(VIEW, 'Preview', column, { retainContextWhenHidden: true });
        await this.attach(panel, uri, shown);
    }

    /** Restores a preview that was open when the window was closed. */
    async deserializeWebviewPanel(panel: vscode.WebviewPanel, state: unknown): Promise<void> {
        const uri = state instanceof Object && 'uri' in state ? uriOf(state.uri) : undefined;
        if (uri) await this.attach(panel, uri, {});
        else panel.dispose();
    }

    /** Requests all pages again from a new server. */
    renew(): void {
        for (const preview of this.previews.values()) preview.renewSoon();
    }

    /** The time that a preview of the document shows, in seconds; 0 without a preview. */
    timeOf(uri: vscode.Uri): number {
        return this.previews.get(uri.toString())?.time ?? 0;
    }

    /** Lets the user click the pixel to debug in the active preview. */
    async pickPixel(): Promise<void> {
        const preview = [...this.previews.values()].find(({ panel }) => panel.active);
        await preview?.panel.webview.postMessage({ type: 'pick' });
    }

    dispose(): void {
        for (const preview of this.previews.values()) preview.panel.dispose();
        for (const subscription of this.subscriptions) subscription.dispose();
    }

    private async attach(panel: vscode.WebviewPanel, uri: vscode.Uri, shown: Shown): Promise<void> {
        const media = vscode.Uri.joinPath(this.context.extensionUri, 'media');
        panel.webview.options = { enableScripts: true, localResourceRoots: [media] };
        panel.title = `Preview ${uri.path.replace(/^.*\//, '')}`;
        const preview = new Preview(panel, uri, shown, this.client, (pixel) => this.debugPixel?.(uri, pixel));
        this.previews.set(uri.toString(), preview);
        panel.onDidDispose(() => {
            preview.end();
            if (this.previews.get(uri.toString()) === preview) this.previews.delete(uri.toString());
        });
        panel.webview.html = await shell(media, uri);
    }
}

class Preview {
    time = 0;
    private timer: ReturnType<typeof setTimeout> | undefined;
    private asked: vscode.CancellationTokenSource | undefined;
    private isReady = false;
    private isStale = true;
    private channels: ChannelFile | null = null;

    constructor(
        readonly panel: vscode.WebviewPanel,
        private readonly uri: vscode.Uri,
        private shown: Shown,
        private readonly client: () => BaseLanguageClient | undefined,
        private readonly debug: (shown: ShownPixel) => void,
    ) {
        panel.webview.onDidReceiveMessage((told: Told) => { this.hear(told); });
        panel.onDidChangeViewState(() => {
            if (this.isStale) this.renewSoon();
        });
    }

    /** Changes to another shader of the document. */
    show(shown: Shown): void {
        this.shown = shown;
        this.renewSoon();
    }

    end(): void {
        clearTimeout(this.timer);
        this.asked?.cancel();
    }

    /** Moves the shown value with the text. */
    follow(changes: readonly vscode.TextDocumentContentChangeEvent[]): void {
        for (const change of changes) this.shown.value?.follow(change);
    }

    /** Requests the page when typing pauses; a hidden preview waits until it is visible. */
    renewSoon(): void {
        this.isStale = true;
        clearTimeout(this.timer);
        if (this.panel.visible && this.isReady) this.timer = setTimeout(() => void this.renew(), PAUSE);
    }

    private async renew(): Promise<void> {
        this.asked?.cancel();
        const asked = new vscode.CancellationTokenSource();
        this.asked = asked;
        this.isStale = false;
        const told = await this.page(asked.token);
        // A later request replaces this one.
        if (this.asked === asked) await this.panel.webview.postMessage(told);
    }

    private async page(token: vscode.CancellationToken): Promise<object> {
        try {
            // The server only knows open documents.
            const document = await vscode.workspace.openTextDocument(this.uri);
            const client = this.client();
            if (!client) throw new Error('The language server is not running.');
            const uri = client.code2ProtocolConverter.asUri(document.uri);
            const { shown } = this;
            const { value, ...place } = shown;
            const asked = value ? { value: value.range() } : place;
            const page = await client.sendRequest(PAGE, { textDocument: { uri }, ...asked }, token);
            // The text before the shader may change. Something else may be shown by now.
            if (this.shown === shown) this.shown = value ? { value, shader: page.shader } : { shader: page.shader };
            this.channels = page.channels;
            return { type: 'page', ...page };
        } catch (error) {
            return { type: 'trouble', words: reason(error) };
        }
    }

    private hear(told: Told): void {
        if (told.type === 'time') this.time = told.time;
        else if (told.type === 'write') void write(this.uri, told.numbers);
        else if (told.type === 'channels') void this.writeChannels();
        else if (told.type === 'pixel') this.debug(told.shown);
        else if (told.type === 'colour') this.show(this.shown.shader === undefined ? {} : { shader: this.shown.shader });
        else {
            this.isReady = true;
            void this.renew();
        }
    }

    private async writeChannels(): Promise<void> {
        const client = this.client();
        if (!client || !this.channels) return;
        try {
            await openChannels(client, this.uri, this.shown.shader, this.channels);
        } catch (error) {
            void vscode.window.showErrorMessage(reason(error));
        }
        this.renewSoon();
    }
}

/** The position of the cursor in a document. */
function cursor(uri: vscode.Uri): Shown {
    const editor = vscode.window.activeTextEditor;
    if (editor?.document.uri.toString() !== uri.toString()) return {};
    const { line, character } = editor.selection.active;
    return { position: { line, character } };
}

function reason(error: unknown): string {
    if (error instanceof ResponseError && error.code === ErrorCodes.MethodNotFound) {
        return 'This version of shaderlint has no preview. Update the program, or clear the setting shaderlint.path.';
    }
    return error instanceof Error ? error.message : String(error);
}

const LITERAL = '(?:true|false|[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?[uU]?)';
const LITERALS = `${LITERAL}(?:[ \\t]*,[ \\t]*${LITERAL})*`;

/** Writes values that were set in the page into their `#define`s and constants. */
async function write(uri: vscode.Uri, numbers: { name: string; text: string }[]): Promise<void> {
    const document = await vscode.workspace.openTextDocument(uri);
    const code = document.getText();
    const edit = new vscode.WorkspaceEdit();
    for (const { name, text } of numbers) {
        // The shader may come from a stranger.
        if (!/^[A-Za-z_]\w*$/.test(name) || !new RegExp(`^${LITERALS}$`).test(text)) continue;
        const head = `(?:#[ \\t]*define[ \\t]+${name}[ \\t]+|(?:.*[ \\t])?const[ \\t][^;/]*\\b${name}[ \\t]*=[ \\t]*)`;
        const found = new RegExp(`^([ \\t]*${head}(?:[iu]?vec[234][ \\t]*)?\\(?[ \\t]*)(${LITERALS})`, 'm').exec(code);
        if (!found) {
            void vscode.window.showWarningMessage(`This file has no \`${name}\` with a number.`);
            continue;
        }
        const start = found.index + (found[1] ?? '').length;
        const end = start + (found[2] ?? '').length;
        edit.replace(uri, new vscode.Range(document.positionAt(start), document.positionAt(end)), text);
    }
    await vscode.workspace.applyEdit(edit);
}

/** The document that a command is for: a URI, as a string or not, or else the active editor's. */
export function uriOf(place: unknown): vscode.Uri | undefined {
    if (place instanceof vscode.Uri) return place;
    if (typeof place === 'string') return vscode.Uri.parse(place);
    return vscode.window.activeTextEditor?.document.uri;
}

/**
 * The document around the page. The page's frame inherits this policy and adds its own, which allows
 * nothing but the server's script by its hash. So this policy has to allow inline scripts, and no text
 * of a shader is ever part of this document.
 */
async function shell(media: vscode.Uri, uri: vscode.Uri): Promise<string> {
    const policy = 'default-src \'none\'; script-src \'unsafe-inline\'; style-src \'unsafe-inline\'; '
        + 'img-src data: blob:; media-src data: blob:';
    const read = async (name: string): Promise<string> => {
        const bytes = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(media, name));
        return new TextDecoder().decode(bytes);
    };
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<style>${await read('preview.css')}</style>
</head>
<body data-uri="${uri.toString().replace(/[&<>"]/g, encodeURIComponent)}">
<main id="pages"></main>
<footer id="pick" hidden>Click the pixel to debug, or press Escape.</footer>
<footer id="value" hidden><span></span><button type="button">Show the image</button></footer>
<footer id="assumed" hidden><span></span><button type="button"></button></footer>
<footer id="write" hidden><span></span><button type="button">Write into the code</button></footer>
<footer id="trouble" role="status">Waiting for the language server.</footer>
<script>${await read('preview.js')}</script>
</body>
</html>`;
}

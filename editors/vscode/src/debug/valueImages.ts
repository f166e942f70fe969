// Values over the screen: a view beside the editor with an image for each chosen expression. A click in an
// image debugs that pixel.
import * as vscode from 'vscode';
import { debuggedPixel, type Stop, type Stops } from './stops';

/** An image for the view, or why there is none. */
interface Shown {
    expression: string;
    /** The value in the debugged pixel. */
    value?: string;
    color?: string;
    error?: string;
    png?: string;
    width?: number;
    height?: number;
    /** The height without the legend. */
    rows?: number;
    /** The number of pixels that have a value. */
    pixels?: number;
    pixel?: [number, number];
}

/** Messages from the view. */
type Told =
    | { type: 'ready' }
    | { type: 'pixel'; pixel: [number, number] }
    | { type: 'remove'; expression: string };

export class ValueImages implements vscode.Disposable {
    private panel: vscode.WebviewPanel | undefined;
    private session: vscode.DebugSession | undefined;
    private expressions: string[] = [];
    private readonly subscriptions: vscode.Disposable;
    /** Number of the last request: an older one that takes longer is not shown. */
    private last = 0;

    constructor(
        private readonly media: vscode.Uri,
        private readonly stops: Stops,
    ) {
        this.subscriptions = vscode.Disposable.from(
            stops.onDidChange((session) => {
                if (session.id === this.session?.id) void this.draw();
            }),
            vscode.debug.onDidTerminateDebugSession((session) => {
                if (session.id === this.session?.id) this.panel?.dispose();
            }),
        );
    }

    /** Shows an expression. */
    async add(session: vscode.DebugSession, expression: string): Promise<void> {
        if (this.session?.id !== session.id) this.expressions = [];
        this.session = session;
        if (!this.expressions.includes(expression)) this.expressions.unshift(expression);
        if (this.panel) this.panel.reveal(undefined, true);
        else await this.open();
        await this.draw();
    }

    dispose(): void {
        this.subscriptions.dispose();
        this.panel?.dispose();
    }

    private async open(): Promise<void> {
        const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
        const options = { enableScripts: true, localResourceRoots: [this.media] };
        const panel = vscode.window.createWebviewPanel('shaderlint.values', 'Values over the Screen', column, options);
        this.panel = panel;
        panel.onDidDispose(() => {
            this.panel = undefined;
            this.expressions = [];
        });
        panel.webview.onDidReceiveMessage((told: Told) => void this.hear(told));
        panel.webview.html = await page(this.media);
    }

    private async hear(told: Told): Promise<void> {
        if (told.type === 'remove') this.expressions = this.expressions.filter((known) => known !== told.expression);
        if (told.type !== 'pixel') return this.draw();
        try {
            await this.session?.customRequest('shaderlint/pixel', { pixel: told.pixel });
        } catch (error) {
            void vscode.window.showErrorMessage(reason(error));
        }
    }

    private async draw(): Promise<void> {
        const number = ++this.last;
        const stop = this.stops.current(this.session);
        // Until a frame is selected, its variables are unknown.
        if (stop?.frameId === undefined || !this.panel) return;
        const pixel = await debuggedPixel(stop);
        const images: Shown[] = [];
        for (const expression of this.expressions) {
            images.push(await shown(stop, expression, pixel));
            if (number !== this.last) return;
        }
        await this.panel.webview.postMessage({ type: 'images', images });
    }
}

async function shown({ session, frameId }: Stop, expression: string, pixel: [number, number]): Promise<Shown> {
    try {
        const image = await session.customRequest('shaderlint/image', { expression, frameId }) as Partial<Shown>;
        const told = session.customRequest('evaluate', { expression, frameId, context: 'watch' });
        // Another pixel may have a value.
        const { result, color } = await Promise.resolve(told).catch(() => ({})) as { result?: string; color?: string };
        const [, rows] = session.configuration['size'] as [number, number];
        return { ...image, rows, expression, pixel, ...result !== undefined && { value: result }, ...color !== undefined && { color } };
    } catch (error) {
        return { expression, error: reason(error) };
    }
}

function reason(error: unknown): string {
    return error instanceof Error ? error.message : String(error);
}

async function page(media: vscode.Uri): Promise<string> {
    const policy = 'default-src \'none\'; script-src \'unsafe-inline\'; style-src \'unsafe-inline\'; img-src data:';
    const read = async (name: string): Promise<string> => {
        const bytes = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(media, name));
        return new TextDecoder().decode(bytes);
    };
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<style>${await read('values.css')}</style>
</head>
<body>
<main id="images"></main>
<script>${await read('values.js')}</script>
</body>
</html>`;
}

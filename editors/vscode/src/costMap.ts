// Cost maps: images of the cost of each pixel, drawn by the program from the saved file.
import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { type Previews, uriOf } from './preview';

interface Kind extends vscode.QuickPickItem {
    /** Value of `--heatmap`. */
    readonly heatmap: string;
}

const KINDS: Kind[] = [
    { heatmap: 'cost', label: 'Operations per pixel' },
    { heatmap: 'steps', label: 'Loop iterations per pixel' },
    { heatmap: 'divergence', label: 'Divergence', description: 'share of the work of its group that a pixel only waits for' },
    { heatmap: 'nan', label: 'NaN and infinity', description: 'where values are not finite' },
];

/** One view for each document and kind of map, redrawn when the document is saved. */
export class CostMaps implements vscode.Disposable {
    private readonly maps = new Map<string, CostMap>();
    private readonly saves: vscode.Disposable;

    constructor(
        private readonly program: () => string,
        private readonly previews: Previews,
    ) {
        this.saves = vscode.workspace.onDidSaveTextDocument(({ uri }) => {
            for (const map of this.maps.values()) {
                if (map.uri.toString() === uri.toString()) map.redraw();
            }
        });
    }

    /** Asks for the kind of map, and shows it. */
    async show(place: unknown): Promise<void> {
        const uri = uriOf(place);
        if (uri?.scheme !== 'file') {
            void vscode.window.showInformationMessage('Save the shader first: cost maps are drawn from the saved file.');
            return;
        }
        const kind = await vscode.window.showQuickPick(KINDS, { title: 'Show cost map' });
        if (!kind) return;
        const document = await vscode.workspace.openTextDocument(uri);
        if (document.isDirty && !await document.save()) return;
        await this.mapOf(uri, kind).draw();
    }

    dispose(): void {
        this.saves.dispose();
        for (const { panel } of this.maps.values()) panel.dispose();
    }

    private mapOf(uri: vscode.Uri, kind: Kind): CostMap {
        const key = `${kind.heatmap} ${uri.toString()}`;
        const known = this.maps.get(key);
        if (known) {
            known.panel.reveal(undefined, true);
            return known;
        }
        const name = `${kind.label}: ${path.basename(uri.fsPath)}`;
        const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
        const panel = vscode.window.createWebviewPanel('shaderlint.costMap', name, column, { localResourceRoots: [] });
        const map = new CostMap(panel, uri, kind, this.program, () => this.previews.timeOf(uri));
        this.maps.set(key, map);
        panel.onDidDispose(() => {
            this.maps.delete(key);
            map.end();
        });
        return map;
    }
}

class CostMap {
    private isStale = false;
    /** Stops the current drawing. */
    private stop: AbortController | undefined;

    constructor(
        readonly panel: vscode.WebviewPanel,
        readonly uri: vscode.Uri,
        private readonly kind: Kind,
        private readonly program: () => string,
        private readonly time: () => number,
    ) {
        panel.onDidChangeViewState(() => {
            if (this.isStale && panel.visible) void this.draw();
        });
    }

    end(): void {
        this.stop?.abort();
    }

    /** Redraws the map; a hidden one when it becomes visible. */
    redraw(): void {
        this.isStale = true;
        if (this.panel.visible) void this.draw();
    }

    async draw(): Promise<void> {
        this.isStale = false;
        this.stop?.abort();
        const stop = new AbortController();
        this.stop = stop;
        const time = this.time();
        const options = {
            location: vscode.ProgressLocation.Notification,
            title: `Drawing the cost map of ${path.basename(this.uri.fsPath)}`,
            cancellable: true,
        };
        const drawn = await vscode.window.withProgress(options, (_, token) => {
            token.onCancellationRequested(() => { stop.abort(); });
            return this.run(time, stop.signal).catch((error: unknown) => ({ picture: undefined, words: String(error) }));
        });
        // The previous image stays if the drawing is cancelled.
        if (!stop.signal.aborted) this.panel.webview.html = page(drawn, time);
    }

    private async run(time: number, signal: AbortSignal): Promise<Drawn> {
        const folder = await mkdtemp(path.join(tmpdir(), 'shaderlint-'));
        try {
            const file = this.uri.fsPath;
            const out = path.join(folder, 'map.png');
            const options = ['--heatmap', this.kind.heatmap, '--time', time.toFixed(3), '-o', out, '--color', 'never'];
            const words = await said(this.program(), ['run', ...options, '--', path.basename(file)], path.dirname(file), signal);
            const picture = await readFile(out).catch(() => undefined);
            // The temporary file means nothing to the user.
            const told = words.split('\n').filter((line) => !line.includes(out)).join('\n');
            return { picture: picture?.toString('base64'), words: told };
        } finally {
            await rm(folder, { recursive: true, force: true });
        }
    }
}

interface Drawn {
    /** A PNG in base64; `undefined` if it could not be drawn, and `words` say why. */
    picture: string | undefined;
    words: string;
}

/** Everything that a program prints, on either stream, or why it could not be started. */
function said(program: string, args: string[], cwd: string, signal: AbortSignal): Promise<string> {
    return new Promise((resolve) => {
        execFile(program, args, { cwd, signal, env: { ...process.env, NO_COLOR: '1' } }, (error, stdout, stderr) => {
            const words = `${stdout}${stderr}`.trim();
            resolve(words || error?.message || '');
        });
    });
}

function page({ picture, words }: Drawn, time: number): string {
    const policy = 'default-src \'none\'; img-src data:; style-src \'unsafe-inline\'';
    const escaped = words.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
    const image = picture ? `<img src="data:image/png;base64,${picture}" alt="Cost map at ${time.toFixed(2)} s">` : '';
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<style>
body { padding: 12px; }
img { display: block; width: 100%; }
pre { white-space: pre-wrap; font: var(--vscode-editor-font-size) var(--vscode-editor-font-family); }
</style>
</head>
<body>
${image}
<pre>${escaped}</pre>
</body>
</html>`;
}

// Colours of vectors, as boxes before the variables in the code, while a session is stopped.
import * as vscode from 'vscode';
import { mentions } from './inlineValues';
import type { Stop, Stops } from './stops';

interface Variable {
    name: string;
    /** As in a style sheet, if the value can be a colour. */
    color?: string;
}

export class Colors implements vscode.Disposable {
    private readonly boxes = vscode.window.createTextEditorDecorationType({
        rangeBehavior: vscode.DecorationRangeBehavior.ClosedClosed,
    });
    private readonly subscriptions: vscode.Disposable;
    /** Number of the last change: an older one that takes longer is not shown. */
    private last = 0;

    constructor(private readonly stops: Stops) {
        this.subscriptions = vscode.Disposable.from(
            stops.onDidChange(() => void this.show()),
            vscode.window.onDidChangeVisibleTextEditors(() => void this.show()),
        );
    }

    dispose(): void {
        this.subscriptions.dispose();
        this.boxes.dispose();
    }

    private async show(): Promise<void> {
        const number = ++this.last;
        const stop = this.stops.current();
        const path = stop?.place?.uri.toString();
        const editors = vscode.window.visibleTextEditors.filter(({ document }) => document.languageId === 'glsl');
        const shown = editors.find(({ document }) => document.uri.toString() === path);
        const boxes = shown && stop ? await boxesOf(shown.document, stop).catch(() => []) : [];
        if (number !== this.last) return;
        for (const editor of editors) editor.setDecorations(this.boxes, editor === shown ? boxes : []);
    }
}

async function boxesOf(document: vscode.TextDocument, { session, scopes, place }: Stop): Promise<vscode.DecorationOptions[]> {
    const [locals] = scopes;
    if (locals === undefined || !place) return [];
    const { variables } = await session.customRequest('variables', { variablesReference: locals }) as { variables: Variable[] };
    const colors = new Map(variables.map(({ name, color }) => [name, color]));
    const found = await mentions(document, place.line);
    return found.flatMap(({ name, range }) => {
        const color = colors.get(name);
        if (color === undefined) return [];
        const box = {
            contentText: ' ', backgroundColor: color, border: '1px solid #888', margin: '0 0.2em 0 0', width: '0.7em', height: '0.7em',
        };
        return [{ range, renderOptions: { before: box } }];
    });
}

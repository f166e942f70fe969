// Which variables a function mentions up to the line at which a session is stopped.
import * as vscode from 'vscode';

/** A mention of a variable, or of something else with its name. */
export interface Mention {
    name: string;
    range: vscode.Range;
}

/** The values of variables, after the lines that mention them. */
export async function inlineValues(document: vscode.TextDocument, view: vscode.Range, { stoppedLocation }: vscode.InlineValueContext): Promise<vscode.InlineValue[]> {
    const found = await mentions(document, stoppedLocation.end.line);
    return found
        .filter(({ range }) => view.contains(range))
        .map(({ name, range }) => new vscode.InlineValueVariableLookup(range, name));
}

/** The mentions in the function around a line, until that line. */
export async function mentions(document: vscode.TextDocument, line: number): Promise<Mention[]> {
    const first = await functionStart(document, line);
    const text = document.getText(new vscode.Range(first, 0, line + 1, 0));
    const start = document.offsetAt(new vscode.Position(first, 0));
    // Neither in comments nor members, calls or directives.
    const words = /\/\/.*|\/\*[^]*?\*\/|^[ \t]*#.*|\.\s*\w+|\b[A-Za-z_]\w*\b(\s*\()?|\d[\w.]*/gm;
    const found: Mention[] = [];
    for (const { 0: name, 1: call, index } of text.matchAll(words)) {
        if (call !== undefined || !/^[A-Za-z_]/.test(name)) continue;
        const range = new vscode.Range(document.positionAt(start + index), document.positionAt(start + index + name.length));
        found.push({ name, range });
    }
    return found;
}

/** The first line of the function around a line. */
async function functionStart(document: vscode.TextDocument, line: number): Promise<number> {
    const command = 'vscode.executeDocumentSymbolProvider';
    const symbols = await vscode.commands.executeCommand<vscode.DocumentSymbol[] | undefined>(command, document.uri);
    const place = new vscode.Position(line, 0);
    const around = (symbols ?? []).filter(({ kind, range }) => kind === vscode.SymbolKind.Function && range.contains(place));
    return around[0]?.range.start.line ?? line;
}

// An expression whose value a preview shows, which moves when the text before it changes.
import * as vscode from 'vscode';

interface Place {
    line: number;
    character: number;
}

/** The place of an expression in a document. */
export class ShownValue {
    private constructor(
        private readonly document: vscode.TextDocument,
        private start: number,
        private end: number,
    ) {}

    /** The expression in a range of the protocol or of the editor. */
    static async of(uri: vscode.Uri, range: { start: Place; end: Place }): Promise<ShownValue> {
        const document = await vscode.workspace.openTextDocument(uri);
        const offset = ({ line, character }: Place): number => document.offsetAt(new vscode.Position(line, character));
        return new ShownValue(document, offset(range.start), offset(range.end));
    }

    /** Its range in the current text. */
    range(): { start: Place; end: Place } {
        const place = (offset: number): Place => {
            const { line, character } = this.document.positionAt(offset);
            return { line, character };
        };
        return { start: place(this.start), end: place(this.end) };
    }

    /** Follows a change of the document. */
    follow({ rangeOffset, rangeLength, text }: vscode.TextDocumentContentChangeEvent): void {
        const grown = text.length - rangeLength;
        const isBefore = rangeOffset + rangeLength <= this.start && !(rangeOffset === this.start && this.start < this.end);
        if (isBefore) this.start += grown;
        if (isBefore || rangeOffset <= this.end) this.end = Math.max(this.start, this.end + grown);
    }
}

/** Whether a command's argument is a range. */
export function isRange(argument: unknown): argument is { start: Place; end: Place } {
    return argument instanceof Object && 'start' in argument && 'end' in argument;
}

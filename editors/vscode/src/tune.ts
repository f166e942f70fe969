// Changes a number in the code with a range in a comment next to it.
import * as vscode from 'vscode';
import type { Range } from 'vscode-languageclient';

/** Number of steps of a range that are suggested. */
const STEPS = 4;

/** Asks for a new value for the number at `range`, and writes it. */
export async function tune(uri: vscode.Uri, range: Range, value: number, min: number, max: number): Promise<void> {
    const document = await vscode.workspace.openTextDocument(uri);
    const { start, end } = range;
    const place = new vscode.Range(start.line, start.character, end.line, end.character);
    const before = document.getText(place);
    // Without a decimal point it is an `int` in GLSL.
    const isWhole = /^[-+]?\d+$/.test(before);
    const written = isWhole && min === 0 && max === 1
        ? await vscode.window.showQuickPick(['0', '1'], { title: 'Off or on', placeHolder: before })
        : await vscode.window.showInputBox({
            title: `From ${min} to ${max}`,
            value: before,
            prompt: steps(min, max).map((step) => text(step, isWhole)).join('   '),
            validateInput: (typed) => refusal(typed, isWhole, Math.min(min, value), Math.max(max, value)),
        });
    // The document may have changed in the meantime.
    if (written === undefined || document.getText(place) !== before) return;
    const edit = new vscode.WorkspaceEdit();
    edit.replace(document.uri, place, text(Number(written), isWhole));
    await vscode.workspace.applyEdit(edit);
}

function steps(min: number, max: number): number[] {
    return Array.from({ length: STEPS + 1 }, (_, i) => min + ((max - min) * i) / STEPS);
}

function refusal(typed: string, isWhole: boolean, least: number, most: number): string | undefined {
    const number = Number(typed);
    if (typed.trim() === '' || !Number.isFinite(number)) return 'Not a number.';
    if (isWhole && !Number.isInteger(number)) return 'Must be an integer, like the number in the code.';
    return number < least || number > most ? `Must be between ${least} and ${most}.` : undefined;
}

/** A number as a GLSL literal. */
export function text(value: number, isWhole: boolean): string {
    if (isWhole) return String(Math.round(value));
    const digits = String(Number(value.toPrecision(6)));
    return /[.e]/.test(digits) ? digits : `${digits}.0`;
}

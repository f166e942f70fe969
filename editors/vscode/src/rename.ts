// Asks for a better name after a refactoring that writes a new one.
import * as vscode from 'vscode';
import type { Position } from 'vscode-languageclient';

/** Puts the cursor on the name at a position, and starts a rename. */
export async function renameAt(uri: vscode.Uri, at: Position): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (editor?.document.uri.toString() !== uri.toString()) return;
    const place = new vscode.Position(at.line, at.character);
    editor.selection = new vscode.Selection(place, place);
    await vscode.commands.executeCommand('editor.action.rename');
}

// Finds the `shaderlint` program.
import { statSync } from 'node:fs';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { SECTION } from './settings';

/** Path of the program: from the settings, bundled with the extension, or on `PATH`. */
export function binary(context: vscode.ExtensionContext): string {
    const settings = vscode.workspace.getConfiguration(SECTION);
    const named = settings.get<string>('path', '').trim();
    if (named !== '') return resolved(named);
    const name = process.platform === 'win32' ? 'shaderlint.exe' : 'shaderlint';
    const packaged = context.asAbsolutePath(path.join('bin', name));
    return isFile(packaged) ? packaged : onPath(name);
}

/** A path from the settings, relative to the home folder or to the first folder of the workspace. */
function resolved(named: string): string {
    const home = process.env['HOME'] ?? process.env['USERPROFILE'] ?? '';
    const fromHome = named.replace(/^~(?=[\\/])/, home);
    if (!/[\\/]/.test(fromHome)) return onPath(fromHome);
    if (path.isAbsolute(fromHome)) return fromHome;
    if (!vscode.workspace.isTrusted) {
        throw new Error(`\`${named}\` is inside this workspace, which is not trusted.`);
    }
    const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? '';
    return path.resolve(folder, fromHome.replaceAll('${workspaceFolder}', folder));
}

/**
 * The full path of a program on `PATH`. Windows would search the current folder first, which belongs to
 * the workspace, so relative folders are skipped as well.
 */
function onPath(name: string): string {
    const file = process.platform === 'win32' && path.extname(name) === '' ? `${name}.exe` : name;
    const folders = (process.env['PATH'] ?? '').split(path.delimiter).filter((folder) => path.isAbsolute(folder));
    const found = folders.map((folder) => path.join(folder, file)).find(isFile);
    if (found === undefined) throw new Error(`\`${name}\` was found neither in the extension nor on PATH.`);
    return found;
}

function isFile(file: string): boolean {
    try {
        return statSync(file).isFile();
    } catch {
        return false;
    }
}

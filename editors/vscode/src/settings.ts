// The user's settings, in the form that the server expects.
import * as vscode from 'vscode';

/** The section of the settings, and the prefix of the commands. */
export const SECTION = 'shaderlint';

/** The command that opens a preview; the server offers it as a code lens. */
export const PREVIEW_COMMAND = 'shaderlint.preview';

/** The command that renames a new name; the server adds it to refactorings. */
export const RENAME_COMMAND = 'shaderlint.rename';

/** The settings that are sent to the server. */
export function serverSettings(): object {
    const settings = vscode.workspace.getConfiguration(SECTION);
    const is = (name: string, byDefault: boolean): boolean => settings.get<boolean>(name, byDefault);
    return {
        run: is('run', true),
        pictures: is('pictures', true),
        hints: {
            parameters: is('hints.parameters', true),
            loopIterations: is('hints.loopIterations', true),
            types: is('hints.types', false),
        },
        lenses: is('lenses', true),
        previewCommand: PREVIEW_COMMAND,
        renameCommand: RENAME_COMMAND,
    };
}

/** The documents that are sent to the server: everything that may contain a shader. */
export function documentSelector(): { scheme: string; language?: string; pattern?: string }[] {
    const languages = [
        'glsl', 'html', 'javascript', 'javascriptreact', 'typescript', 'typescriptreact', 'vue', 'svelte', 'astro',
        'markdown', 'mdx',
    ];
    // In a virtual workspace, files have another scheme.
    const folders = (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.scheme);
    const schemes = [...new Set(['file', ...folders])];
    const selector: { scheme: string; language?: string; pattern?: string }[] = languages.flatMap((language) =>
        [...schemes, 'untitled'].map((scheme) => ({ scheme, language })));
    if (vscode.workspace.getConfiguration(SECTION).get<boolean>('exports', true)) {
        selector.push(...schemes.map((scheme) => ({ scheme, language: 'json', pattern: '**/*.{json,shadertoy}' })));
    }
    return selector;
}

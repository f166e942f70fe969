// The files of a workspace that a server without a disk is sent, and their addresses.
import * as vscode from 'vscode';

/** A file for the server; `null` if it was removed. */
export interface SentFile {
    uri: string;
    text: string | null;
}

/** Limits of what is read: a folder may be a whole repository, each file of which is downloaded. */
const MAX_ENTRIES = 20_000;
const MAX_FILES = 1000;
const MAX_FILE_BYTES = 1024 * 1024;
const MAX_BYTES = 16 * 1024 * 1024;
/** Files that are read at the same time. */
const AT_ONCE = 16;

/** What shaders are made of, and their configuration. */
const SHADERS = /\.(glsl|vert|frag|vs|fs|vsh|fsh|glslv|glslf|shadertoy)$|^(shaderlint\.toml|package\.json)$/;
/** What may contain shaders, or names of theirs. */
const HOLDERS = /\.(html?|[cm]?jsx?|[cm]?tsx?|vue|svelte|astro|mdx?|json)$/;
const WATCHED = '**/*.{glsl,vert,frag,vs,fs,vsh,fsh,glslv,glslf,shadertoy,html,htm,js,mjs,cjs,jsx,ts,mts,cts,tsx,vue,svelte,'
    + 'astro,md,mdx,json,toml}';

/** The server knows files by path only, so the path has the scheme and authority of other addresses. */
export function toServer(uri: vscode.Uri): string {
    if (uri.scheme === 'file' || uri.scheme === 'untitled') return uri.toString();
    const place = `/@${uri.scheme}@${encodeURIComponent(uri.authority)}`;
    return vscode.Uri.from({ scheme: 'file', path: `${place}${uri.path}` }).toString();
}

/** The address of a file of the server. */
export function fromServer(text: string): vscode.Uri {
    const uri = vscode.Uri.parse(text);
    const found = uri.scheme === 'file' ? /^\/@([^@/]+)@([^/]*)(\/.*)$/.exec(uri.path) : null;
    if (!found) return uri;
    const [, scheme = '', authority = '', path = ''] = found;
    return vscode.Uri.from({ scheme, authority: decodeURIComponent(authority), path });
}

/** The files of the workspace, and their changes. */
export class WorkspaceFiles implements vscode.Disposable {
    private watcher: vscode.Disposable | undefined;

    /** Reads the files of the workspace, shaders first. */
    async read(): Promise<SentFile[]> {
        const [shaders, holders] = await this.list();
        const all = [...shaders, ...holders].slice(0, MAX_FILES);
        const sent: SentFile[] = [];
        let bytes = 0;
        for (let i = 0; i < all.length && bytes < MAX_BYTES; i += AT_ONCE) {
            const read = await Promise.all(all.slice(i, i + AT_ONCE).map(readFile));
            for (const file of read) {
                if (file.text === null) continue;
                bytes += file.text.length;
                sent.push(file);
            }
        }
        return sent;
    }

    /** Reports changes from now on. */
    follow(tell: (changed: SentFile[]) => void): void {
        this.watcher?.dispose();
        const watcher = vscode.workspace.createFileSystemWatcher(WATCHED);
        const changed = (uri: vscode.Uri): void => {
            if (isLeftOut(uri)) return;
            void readFile(uri).then((file) => { tell([file]); });
        };
        this.watcher = vscode.Disposable.from(
            watcher,
            watcher.onDidCreate(changed),
            watcher.onDidChange(changed),
            watcher.onDidDelete((uri) => { tell([{ uri: toServer(uri), text: null }]); }),
        );
    }

    dispose(): void {
        this.watcher?.dispose();
    }

    /**
     * The shaders and the other files, outer folders first. Not every workspace can be searched, but each can
     * be listed.
     */
    private async list(): Promise<[vscode.Uri[], vscode.Uri[]]> {
        const shaders: vscode.Uri[] = [];
        const holders: vscode.Uri[] = [];
        let folders = (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri);
        let left = MAX_ENTRIES;
        while (folders.length > 0 && left > 0) {
            const below: vscode.Uri[] = [];
            for (let i = 0; i < folders.length && left > 0; i += AT_ONCE) {
                const listed = await Promise.all(folders.slice(i, i + AT_ONCE).map(entries));
                for (const [uri, type] of listed.flat()) {
                    left--;
                    const name = uri.path.replace(/^.*\//, '');
                    if (isLeftOut(uri)) continue;
                    if (type & vscode.FileType.Directory) below.push(uri);
                    else if (SHADERS.test(name)) shaders.push(uri);
                    else if (HOLDERS.test(name)) holders.push(uri);
                }
            }
            folders = below;
        }
        return [shaders, holders];
    }
}

/** Whether a file or folder is no source of the project. */
function isLeftOut(uri: vscode.Uri): boolean {
    const folder = vscode.workspace.getWorkspaceFolder(uri)?.uri.path ?? '';
    return /\/(\.[^/]*|node_modules)(\/|$)/.test(uri.path.slice(folder.length));
}

async function entries(folder: vscode.Uri): Promise<[vscode.Uri, vscode.FileType][]> {
    try {
        const all = await vscode.workspace.fs.readDirectory(folder);
        return all.map(([name, type]) => [vscode.Uri.joinPath(folder, name), type]);
    } catch {
        // Another one may be readable.
        return [];
    }
}

/** A file with its text; without one if it is large, binary or gone. */
async function readFile(uri: vscode.Uri): Promise<SentFile> {
    const file: SentFile = { uri: toServer(uri), text: null };
    try {
        const bytes = await vscode.workspace.fs.readFile(uri);
        if (bytes.length <= MAX_FILE_BYTES) file.text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
        // As if it did not exist.
    }
    return file;
}

// The debugger: sessions of `shaderlint dap`, the commands that the protocol does not have, and what is shown
// while a session is stopped.
import * as vscode from 'vscode';
import { Colors } from './colors';
import { inlineValues } from './inlineValues';
import { debuggedPixel, type Stop, Stops } from './stops';
import { ValueImages } from './valueImages';

export const DEBUG_TYPE = 'shaderlint';

/** Width and height of the debugged image, unless something else is given. */
const SIZE: [number, number] = [320, 180];

/** A pixel of a preview. */
export interface ShownPixel {
    pixel: [number, number];
    size: [number, number];
    time: number;
    frame: number;
}

/** What menus of variables and watches pass to commands. */
interface Chosen {
    variable?: { name?: string; evaluateName?: string };
    name?: string;
    evaluateName?: string;
}

export function activateDebugger(context: vscode.ExtensionContext, program: () => string): { dispose(): unknown }[] {
    const stops = new Stops(DEBUG_TYPE);
    const images = new ValueImages(vscode.Uri.joinPath(context.extensionUri, 'media'), stops);
    const command = (name: string, act: (argument?: unknown) => Promise<void>): vscode.Disposable =>
        vscode.commands.registerCommand(`shaderlint.debug.${name}`, (argument?: unknown) => shown(act(argument)));
    const step = (name: string): vscode.Disposable => command(name, async () => {
        const { session, threadId } = current(stops);
        await session.customRequest(`shaderlint/${name}`, { threadId });
    });
    return [
        stops,
        images,
        new Colors(stops),
        vscode.languages.registerInlineValuesProvider('glsl', { provideInlineValues: inlineValues }),
        vscode.debug.registerDebugConfigurationProvider(DEBUG_TYPE, {
            provideDebugConfigurations: () => [{ ...DEFAULT }],
            resolveDebugConfiguration: (_, configuration) => completed(configuration),
        }),
        vscode.debug.registerDebugAdapterDescriptorFactory(DEBUG_TYPE, {
            createDebugAdapterDescriptor: () => new vscode.DebugAdapterExecutable(program(), ['dap']),
        }),
        vscode.workspace.onDidSaveTextDocument((document) => void shown(reload(document))),
        step('nextIteration'),
        step('stepBackIn'),
        step('stepBackOut'),
        command('written', async (chosen) => {
            const { session, frameId } = current(stops);
            await session.customRequest('shaderlint/written', { frameId, expression: await expressionOf(chosen) });
        }),
        command('image', async (chosen) => {
            await images.add(current(stops).session, await expressionOf(chosen));
        }),
        command('pixel', async () => {
            const stop = current(stops);
            await choosePixel(stop);
        }),
    ];
}

/** Debugs a pixel that a preview shows. */
export async function debugPixel(uri: vscode.Uri, { pixel, size, time, frame }: ShownPixel): Promise<void> {
    if (uri.scheme !== 'file') {
        void vscode.window.showInformationMessage('Save the shader first: the debugger reads the saved file.');
        return;
    }
    await vscode.debug.startDebugging(vscode.workspace.getWorkspaceFolder(uri), {
        ...DEFAULT, name: `Pixel ${pixel.join(', ')}`, program: uri.fsPath, pixel, size, time, frame,
    });
}

const DEFAULT: vscode.DebugConfiguration = {
    type: DEBUG_TYPE, request: 'launch', name: 'Debug shader', program: '${file}', size: SIZE,
};

/** A configuration with what it lacks: without a file `launch.json` all of it. */
function completed(configuration: vscode.DebugConfiguration): vscode.DebugConfiguration | undefined {
    const isNew = !configuration.type && !configuration.request && !configuration.name;
    const document = vscode.window.activeTextEditor?.document;
    const isMissing = configuration['program'] === undefined;
    if (isMissing && document?.languageId !== 'glsl') {
        void vscode.window.showInformationMessage('Open a shader first to debug it.');
        return undefined;
    }
    if (isMissing && document?.uri.scheme !== 'file') {
        void vscode.window.showInformationMessage('Save the shader first: the debugger reads the saved file.');
        return undefined;
    }
    return isNew ? { ...DEFAULT } : { ...DEFAULT, ...configuration };
}

/** Reads the program again when one of its files is saved, at the same pixel and line. */
async function reload(document: vscode.TextDocument): Promise<void> {
    const session = vscode.debug.activeDebugSession;
    if (session?.type !== DEBUG_TYPE) return;
    const file = document.uri.fsPath;
    const program = String(session.configuration['program']);
    const isPart = file === program || file.startsWith(program.replace(/[\\/]*$/, '/')) || /channels\.toml$/.test(file);
    if (!isPart && !(await loaded(session)).includes(file)) return;
    await session.customRequest('shaderlint/reload');
}

/** The paths of the files of the program. */
async function loaded(session: vscode.DebugSession): Promise<(string | undefined)[]> {
    const answer = await session.customRequest('loadedSources') as { sources: { path?: string }[] };
    return answer.sources.map(({ path }) => path && vscode.Uri.file(path).fsPath);
}

/** Where the active session is stopped. */
function current(stops: Stops): Stop {
    const stop = stops.current();
    if (!stop) throw new Error('No shader is being debugged.');
    return stop;
}

/** The expression that a command is for: of a menu, or else the selected one, or the word at the cursor. */
async function expressionOf(argument: unknown): Promise<string> {
    if (argument instanceof Object && !(argument instanceof vscode.Uri)) {
        const { variable, ...watch } = argument as Chosen;
        const name = variable?.evaluateName ?? variable?.name ?? watch.evaluateName ?? watch.name;
        if (name) return name;
    }
    const editor = vscode.window.activeTextEditor;
    const { selection } = editor ?? {};
    const range = selection?.isEmpty ? editor?.document.getWordRangeAtPosition(selection.active) : selection;
    const selected = (range && editor?.document.getText(range).trim()) ?? '';
    if (selected !== '') return selected;
    const typed = await vscode.window.showInputBox({ title: 'Expression', prompt: 'A variable or an expression of GLSL' });
    if (!typed) throw new vscode.CancellationError();
    return typed;
}

async function choosePixel(stop: Stop): Promise<void> {
    const { session } = stop;
    const pixel = await debuggedPixel(stop);
    const typed = await vscode.window.showInputBox({
        title: 'Choose pixel',
        prompt: 'x and y from the lower left corner, and optionally the time in seconds',
        value: pixel.join(', '),
        validateInput: (text) => pixelIn(text) ? undefined : 'Expected x, y or x, y, time',
    });
    const found = typed === undefined ? undefined : pixelIn(typed);
    if (found) await session.customRequest('shaderlint/pixel', found);
}

/** The pixel, and the time if it is given, in a text. */
function pixelIn(text: string): { pixel: [number, number]; time?: number } | undefined {
    const found = /^\s*(\d+)[\s,]+(\d+)(?:[\s,]+(\d+(?:\.\d*)?|\.\d+))?\s*$/.exec(text);
    if (!found) return undefined;
    const [, x, y, time] = found;
    return { pixel: [Number(x), Number(y)], ...time !== undefined && { time: Number(time) } };
}

/** Shows the error of an action. */
async function shown(action: Promise<void>): Promise<void> {
    try {
        await action;
    } catch (error) {
        if (error instanceof vscode.CancellationError) return;
        void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
    }
}

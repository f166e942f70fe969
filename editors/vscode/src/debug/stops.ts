// Where each session is stopped, and which frame of the stack is selected. The editor asks for the scopes of
// the frame that it shows.
import * as vscode from 'vscode';

/** A selected frame of a stopped session. */
export interface Stop {
    readonly session: vscode.DebugSession;
    readonly threadId: number | undefined;
    readonly frameId: number | undefined;
    /** The file and the line, counted from 0, if the frame has a file. */
    readonly place?: { uri: vscode.Uri; line: number };
    /** The references to the scopes. */
    readonly scopes: number[];
}

interface Frame {
    id: number;
    line: number;
    source?: { path?: string };
}

/** The parts of messages that are read. */
interface Message {
    type: string;
    event?: string;
    command?: string;
    seq: number;
    request_seq?: number;
    arguments?: { threadId?: number; frameId?: number };
    body?: { threadId?: number; stackFrames?: Frame[]; scopes?: { variablesReference: number }[] };
}

export class Stops implements vscode.Disposable {
    private readonly stops = new Map<string, Stop>();
    private readonly changed = new vscode.EventEmitter<vscode.DebugSession>();
    private readonly subscription: vscode.Disposable;
    /** Fires when a session stops, when another frame is selected, and when it goes on or ends. */
    readonly onDidChange = this.changed.event;

    constructor(type: string) {
        this.subscription = vscode.debug.registerDebugAdapterTrackerFactory(type, {
            createDebugAdapterTracker: (session) => this.tracker(session),
        });
    }

    /** The stop of a session, by default the active one; `undefined` while it runs. */
    current(session = vscode.debug.activeDebugSession): Stop | undefined {
        return session && this.stops.get(session.id);
    }

    dispose(): void {
        this.subscription.dispose();
        this.changed.dispose();
    }

    private set(session: vscode.DebugSession, stop: Stop | undefined): void {
        if (stop) this.stops.set(session.id, stop);
        else this.stops.delete(session.id);
        this.changed.fire(session);
    }

    private tracker(session: vscode.DebugSession): vscode.DebugAdapterTracker {
        const asked = new Map<number, Message>();
        const frames = new Map<number, Frame & { threadId: number | undefined }>();
        return {
            onWillReceiveMessage: (message: Message) => {
                if (message.command === 'scopes' || message.command === 'stackTrace') asked.set(message.seq, message);
            },
            onDidSendMessage: (message: Message) => {
                const request = asked.get(message.request_seq ?? -1);
                asked.delete(message.request_seq ?? -1);
                if (message.event === 'stopped') {
                    frames.clear();
                    this.set(session, { session, threadId: message.body?.threadId, frameId: undefined, scopes: [] });
                } else if (message.event === 'continued' || message.event === 'terminated') {
                    this.set(session, undefined);
                } else if (request?.command === 'stackTrace') {
                    const threadId = request.arguments?.threadId;
                    for (const frame of message.body?.stackFrames ?? []) frames.set(frame.id, { ...frame, threadId });
                } else if (request?.command === 'scopes' && message.body?.scopes) {
                    const frameId = request.arguments?.frameId;
                    const frame = frames.get(frameId ?? -1);
                    const path = frame?.source?.path;
                    this.set(session, {
                        session,
                        threadId: frame?.threadId,
                        frameId,
                        scopes: message.body.scopes.map(({ variablesReference }) => variablesReference),
                        ...frame && path && { place: { uri: vscode.Uri.file(path), line: frame.line - 1 } },
                    });
                }
            },
            onWillStopSession: () => { this.set(session, undefined); },
            onExit: () => { this.set(session, undefined); },
        };
    }
}

/** The pixel of the selected thread, which is named after it. */
export async function debuggedPixel({ session, threadId }: Stop): Promise<[number, number]> {
    const { threads } = await session.customRequest('threads') as { threads: { id: number; name: string }[] };
    const name = threads.find(({ id }) => id === threadId)?.name ?? '';
    const [x = 0, y = 0] = [...name.matchAll(/\d+/g)].map(Number);
    return [x, y];
}

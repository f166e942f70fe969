import type { Source } from "./index.js";

/** A language server as a transport: messages are JSON texts. */
export interface Server {
  send(message: string): void;
  subscribe(handler: (message: string) => void): void;
  unsubscribe(handler: (message: string) => void): void;
  /** Ends the workers. */
  close(): void;
}

/** Starts a language server in a worker. */
export function startServer(options?: {
  source?: Source;
  /** Starts a worker that runs `worker.js`, or a port with the same methods. */
  worker?: () => Pick<Worker, "postMessage" | "onmessage" | "terminate">;
  /** Milliseconds without changes before shaders are run. */
  pause?: number;
}): Promise<Server>;

// The language server for a page: a worker that is replaced if it does not answer.
//
// A worker cannot be interrupted while it runs a shader. So the texts of all documents are known
// here too, and a spare worker is ready to continue with them.

import { compile } from "./index.js";
import { Documents } from "./documents.js";

/** Milliseconds without changes before shaders are run. */
const PAUSE = 300;
/** Milliseconds that a message waits for a run to end. */
const PATIENCE = 20;
/** Milliseconds that anything else may take. */
const LIMIT = 5000;

/** The number of messages that only repeat what another worker knew. */
const REPLAY = -1;

/** Starts a worker that runs `worker.js`. */
function webWorker() {
  return new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
}

/**
 * A language server as a transport of messages, which are JSON texts.
 * @param {{ source?: Parameters<typeof compile>[0], worker?: () => Worker, pause?: number }} [options]
 */
export async function startServer(options = {}) {
  const module = compile(options.source);
  // The worker starts while the module is loaded.
  const server = new Server(module, options.worker ?? webWorker, options.pause);
  try {
    await module;
  } catch (error) {
    server.close();
    throw error;
  }
  return server;
}

class Server {
  #module;
  #create;
  #pause;
  #worker;
  #spare;
  #handlers = new Set();
  #documents = new Documents();
  /** The messages that the worker has, by number, and `run` for a run. */
  #waiting = new Map();
  #count = 0;
  #timers = { run: undefined, limit: undefined };

  constructor(module, create, pause = PAUSE) {
    this.#module = module;
    this.#create = create;
    this.#pause = pause;
    this.#worker = this.#start();
  }

  /** Handlers get the messages of the server. */
  subscribe(handler) {
    this.#handlers.add(handler);
  }

  unsubscribe(handler) {
    this.#handlers.delete(handler);
  }

  /** Sends a message of the client. */
  send(text) {
    const message = JSON.parse(text);
    if (this.#documents.take(message)) this.#schedule();
    this.#post(message);
  }

  /** Ends the server. */
  close() {
    clearTimeout(this.#timers.run);
    clearTimeout(this.#timers.limit);
    this.#worker.terminate();
    this.#spare?.terminate();
  }

  #start() {
    const worker = this.#create();
    worker.onmessage = ({ data }) => this.#received(worker, data);
    this.#module.then((module) => worker.postMessage({ module })).catch(() => {});
    return worker;
  }

  #schedule() {
    clearTimeout(this.#timers.run);
    this.#timers.run = setTimeout(() => {
      // A spare worker starts when the first one may be busy, so that it does not delay the first answers.
      this.#spare ??= this.#start();
      this.#post("run");
    }, this.#pause);
  }

  #post(message) {
    const number = ++this.#count;
    this.#waiting.set(number, message);
    this.#tell(message === "run" ? { number, run: true } : { number, message });
    this.#watch();
  }

  /** The module comes before all other messages. */
  #tell(data) {
    const worker = this.#worker;
    this.#module.then(() => worker.postMessage(data)).catch(() => {});
  }

  /** Limits the time until the next answer of the worker. */
  #watch() {
    clearTimeout(this.#timers.limit);
    if (this.#waiting.size === 0) return;
    const [first] = this.#waiting.values();
    const isHeldUp = first === "run" && this.#waiting.size > 1;
    this.#timers.limit = setTimeout(() => this.#replace(), isHeldUp ? PATIENCE : LIMIT);
  }

  #received(worker, { number, messages, crash }) {
    if (worker !== this.#worker) return;
    if (number === REPLAY) {
      // The client got the answer to `initialize` from the first worker.
      this.#deliver(messages?.filter((message) => message.method !== undefined) ?? []);
      return;
    }
    const done = this.#waiting.get(number);
    this.#waiting.delete(number);
    this.#watch();
    if (crash !== undefined) {
      this.#fail(done, crash);
      this.#replace();
      return;
    }
    this.#deliver(messages);
  }

  #deliver(messages) {
    for (const message of messages) {
      const text = JSON.stringify(message);
      for (const handler of this.#handlers) handler(text);
    }
  }

  /** Answers a request that cannot be answered. */
  #fail(message, reason) {
    if (message?.id === undefined || message.method === undefined) return;
    const error = { code: -32603, message: reason };
    this.#deliver([{ jsonrpc: "2.0", id: message.id, error }]);
  }

  /** Continues in another worker, with the documents as they are now. */
  #replace() {
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#worker.terminate();
    this.#worker = this.#spare ?? this.#start();
    this.#spare = undefined;
    const silent = this.#documents.replay();
    for (const message of silent) this.#tell({ number: REPLAY, message });
    // What does not depend on a run and took too long would do so again.
    const wasRunning = waiting.includes("run");
    for (const message of waiting) {
      const isRequest = message.id !== undefined && message.method !== undefined;
      if (!isRequest) continue;
      if (wasRunning) this.#post(message);
      else this.#fail(message, "the request took too long");
    }
    if (wasRunning) this.#schedule();
  }
}

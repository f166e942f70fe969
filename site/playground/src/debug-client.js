// A client of the debugger. One worker steps; another one counts what breakpoints hit, so that steps need not wait.

/** Milliseconds that an answer may take. */
const LIMIT = 20_000;

const start = () => new Worker(new URL('./debug-worker.js', import.meta.url), { type: 'module' });
const message = (command, args) => ({ type: 'request', seq: 1, command, arguments: args });

/** A session of the debugger. */
export class DebugClient {
  /** @type {Worker | undefined} */
  #worker;
  /** The worker that counts. @type {Worker | undefined} */
  #counter;
  /** Who waits for answers, in the order of the questions. */
  #waiting = [];
  #timer;

  /** Whether there is a worker, which has what was launched. */
  get isRunning() {
    return this.#worker !== undefined;
  }

  /**
   * Sends a request. Returns its body, and the events that came with it.
   * @param {string} command
   * @param {object} [args]
   * @returns {Promise<{ body: any, events: any[] }>}
   */
  ask(command, args = {}) {
    this.#worker ??= this.#opened();
    this.#worker.postMessage({ messages: [message(command, args)] });
    return new Promise((resolve, reject) => {
      this.#waiting.push({ resolve, reject });
      this.#limit();
    });
  }

  /**
   * Counts the pixels that hit breakpoints, instead of what was counted before.
   * @param {object} launch
   * @param {{ file: string, breakpoints: any[] }[]} sources
   * @returns {Promise<(string | undefined)[][]>} what each breakpoint hits, in words
   */
  count(launch, sources) {
    this.#counter?.terminate();
    const counter = start();
    this.#counter = counter;
    const sets = sources.map(({ file, breakpoints }) => message('setBreakpoints', { source: { path: file }, breakpoints }));
    const messages = [message('initialize'), message('launch', launch), ...sets, message('configurationDone')];
    return new Promise((resolve, reject) => {
      const end = (settle) => {
        counter.terminate();
        settle();
      };
      counter.onmessage = ({ data: { answers, error } }) => end(() => {
        if (error !== undefined) {
          reject(new Error(error));
          return;
        }
        const hits = new Map(answers.filter(({ event }) => event === 'breakpoint').map(({ body }) => [body.breakpoint.id, body.breakpoint.message]));
        const placed = answers.filter(({ command }) => command === 'setBreakpoints');
        resolve(placed.map(({ body }) => (body?.breakpoints ?? []).map(({ id }) => hits.get(id))));
      });
      counter.onerror = () => end(() => reject(new Error('the module cannot be loaded')));
      counter.postMessage({ messages, isCounted: true });
    });
  }

  close() {
    this.#counter?.terminate();
    this.#counter = undefined;
    this.#end(new DOMException('the debugger was closed', 'AbortError'));
  }

  #opened() {
    const worker = start();
    worker.onmessage = ({ data: { answers, error } }) => this.#answered(answers, error);
    worker.onerror = () => this.#end(new Error('the module cannot be loaded'));
    return worker;
  }

  #answered(answers, error) {
    if (error !== undefined) {
      this.#end(new Error(error));
      return;
    }
    const { resolve, reject } = this.#waiting.shift();
    this.#limit();
    const [response, ...events] = answers;
    if (response.success) resolve({ body: response.body ?? {}, events });
    else reject(new Error(response.message));
  }

  /** Limits the time until the next answer. */
  #limit() {
    clearTimeout(this.#timer);
    if (this.#waiting.length > 0) this.#timer = setTimeout(() => this.#end(new Error('stopped after 20 s')), LIMIT);
  }

  #end(error) {
    clearTimeout(this.#timer);
    this.#worker?.terminate();
    this.#worker = undefined;
    for (const { reject } of this.#waiting.splice(0)) reject(error);
  }
}

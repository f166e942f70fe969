// Runs a shader on the processor, one request at a time.

/** Milliseconds that a run may take. */
const LIMIT = 20_000;
/** Milliseconds that a run may still take when another one waits. */
const GRACE = 1000;

const replaced = () => new DOMException('another run began', 'AbortError');

/** Runs shaders in a worker that can be stopped. */
export class Runner {
  /** @type {Worker | undefined} */
  #worker;
  /** The run that has not answered yet, and the latest one after it. */
  #current;
  #next;

  /**
   * Runs a shader. Of several runs that wait for another one, only the latest takes place: the promises of the
   * others are rejected with an `AbortError`.
   * @param {import('./passes.js').Files} files
   * @param {object} options as those of `Shaderlint.run`
   * @param {import('./passes.js').Files} [other] another version
   */
  run(files, options, other) {
    return new Promise((resolve, reject) => {
      const request = { message: { files, options, other }, resolve, reject };
      const current = this.#current;
      if (!current) {
        this.#start(request);
        return;
      }
      this.#next?.reject(replaced());
      this.#next = request;
      setTimeout(() => { if (this.#current === current) this.#kill(replaced()); }, GRACE);
    });
  }

  #start(request) {
    this.#current = request;
    this.#worker ??= new Worker(new URL('./run-worker.js', import.meta.url), { type: 'module' });
    request.timer = setTimeout(() => this.#kill(new Error('stopped after 20 s')), LIMIT);
    this.#worker.onmessage = ({ data: { result, error } }) => this.#end(() => {
      if (error === undefined) request.resolve(result);
      else request.reject(new Error(error));
    });
    this.#worker.onerror = () => this.#kill(new Error('the module cannot be loaded'));
    this.#worker.postMessage(request.message);
  }

  /** Settles the run, and starts the one that waits. */
  #end(settle) {
    clearTimeout(this.#current.timer);
    const next = this.#next;
    this.#current = undefined;
    this.#next = undefined;
    settle();
    if (next) this.#start(next);
  }

  #kill(error) {
    this.#worker.terminate();
    this.#worker = undefined;
    const { reject } = this.#current;
    this.#end(() => reject(error));
  }
}

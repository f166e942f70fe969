// Runs a shader on the processor, one request at a time.

/** Milliseconds that a run may take. */
const PATIENCE = 20_000;

/** Runs shaders in a worker that can be stopped. */
export class Runner {
  #worker;
  /** Ends the run that has not answered yet. @type {((error: Error) => void) | undefined} */
  #stop;

  /**
   * Runs a shader. A run before it that has not ended is stopped.
   * @param {import('./passes.js').Files} files
   * @param {object} options as those of `Shaderlint.run`
   * @param {import('./passes.js').Files} [other] another version
   */
  run(files, options, other) {
    this.#stop?.(new DOMException('another run began', 'AbortError'));
    this.#worker ??= new Worker(new URL('./run-worker.js', import.meta.url), { type: 'module' });
    const worker = this.#worker;
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => this.#stop?.(new Error('stopped after 20 s')), PATIENCE);
      const end = () => {
        clearTimeout(timer);
        this.#stop = undefined;
      };
      this.#stop = (error) => {
        end();
        worker.terminate();
        this.#worker = undefined;
        reject(error);
      };
      worker.onmessage = ({ data: { result, error } }) => {
        end();
        if (error === undefined) resolve(result);
        else reject(new Error(error));
      };
      worker.onerror = () => this.#stop?.(new Error('the module cannot be loaded'));
      worker.postMessage({ files, other, options });
    });
  }
}

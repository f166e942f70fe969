// shaderlint as a WebAssembly module: texts in, findings out. Works in pages, workers and Node.

/** A module that uses SIMD: `v128.const` in a function. */
const SIMD = Uint8Array.of(
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 22, 1, 20, 0, 253, 12,
  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 11,
);

/** The address of the module for this machine. */
function address() {
  return WebAssembly.validate(SIMD)
    ? new URL("./shaderlint.wasm", import.meta.url)
    : new URL("./shaderlint-plain.wasm", import.meta.url);
}

/** The address of the module that ports shaders. */
export function portAddress() {
  return new URL("./shaderport.wasm", import.meta.url);
}

/**
 * Compiles a module.
 * @param {URL | string | Response | BufferSource | WebAssembly.Module} [source]
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compile(source = address()) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return WebAssembly.compile(source);
  }
  const isFile = String(source).startsWith("file:");
  if (isFile && typeof process === "object") {
    const { readFile } = await import(/* @vite-ignore */ "node:fs/promises");
    return WebAssembly.compile(await readFile(new URL(source)));
  }
  const response = source instanceof Response ? source : await fetch(source);
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
  // A server that does not know the type of the file must not prevent the start.
  const isTyped = response.headers.get("content-type")?.startsWith("application/wasm");
  return isTyped
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

/** An instance of the module. */
export class Shaderlint {
  #module;
  #exports;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#module = module;
    this.#start();
  }

  /**
   * Compiles and starts a module.
   * @param {Parameters<typeof compile>[0]} [source]
   */
  static async load(source) {
    return new Shaderlint(await compile(source));
  }

  #start() {
    this.#exports = new WebAssembly.Instance(this.#module, {}).exports;
  }

  /** Sends a request as it is. */
  request(method, params) {
    const bytes = new TextEncoder().encode(JSON.stringify({ method, params }));
    let text;
    try {
      const { request, answer, length, memory } = this.#exports;
      // Each call may grow the memory, which gives it another buffer.
      const room = request(bytes.length);
      new Uint8Array(memory.buffer, room, bytes.length).set(bytes);
      const start = answer();
      text = new TextDecoder().decode(new Uint8Array(memory.buffer, start, length()));
    } catch (cause) {
      // The memory of an instance that trapped is not valid any more.
      this.#start();
      throw new Error("internal error: shaderlint crashed on this input; please report it", {
        cause,
      });
    }
    const { result, error } = JSON.parse(text);
    if (error !== undefined) throw new Error(error);
    return result;
  }

  /** Checks a text. Returns what `--format json` prints. */
  check(text, options = {}) {
    const { output } = this.request("check", { name: "shader.glsl", text, ...options });
    return JSON.parse(output);
  }

  /** Checks a text. Returns what the command line prints, in the format `options.format`. */
  report(text, options = {}) {
    const params = { name: "shader.glsl", text, format: "human", ...options };
    return this.request("check", params);
  }

  /** Applies the fixes of a text. */
  fix(text, options = {}) {
    return this.request("fix", { name: "shader.glsl", text, ...options });
  }

  /** Formats a text. */
  format(text, options = {}) {
    return this.request("format", { name: "shader.glsl", text, ...options });
  }

  /**
   * Draws a frame, traces a pixel or compares two versions, as `shaderlint run` does; only the module at
   * `portAddress()` does.
   */
  run(text, options = {}) {
    return this.request("run", { name: "shader.glsl", text, ...options });
  }

  /**
   * Passes a message of the Debug Adapter Protocol to the debugger. Returns its messages for the client; only the
   * module at `portAddress()` has it.
   */
  debug(message) {
    return this.request("debug", message);
  }

  /** Counts the pixels that hit new breakpoints, when no message waits. Returns messages for the client. */
  debugIdle() {
    return this.request("debugIdle");
  }

  /** The page of a rule, compile error or host, in Markdown. */
  explain(name) {
    return this.request("explain", { name });
  }

  /** All rules and compile errors. */
  rules() {
    return this.request("rules");
  }

  /** Ports a shader or export; only the module at `portAddress()` does. */
  port(text, options = {}) {
    return this.request("port", { name: "shader.glsl", text, output: "shader.html", ...options });
  }

  /** The data of a shader for `playerPage()`; only the module at `portAddress()` has it. */
  playerData(text, options = {}) {
    return this.request("playerData", { name: "shader.glsl", text, ...options });
  }

  /** The page that plays the shaders which the page around it sends. */
  playerPage() {
    return this.request("playerPage");
  }

  /** Passes a message to the language server. Returns its messages for the client. */
  lsp(message) {
    return this.request("lsp", message);
  }

  /** Runs the shaders of documents that changed. Returns messages for the client. */
  runChanged() {
    return this.request("runChanged");
  }
}

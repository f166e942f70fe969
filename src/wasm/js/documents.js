// The state of a client as the messages that lead to it.

/** The offset of a position in a text, in UTF-16 code units. */
function offset(text, { line, character }) {
  let start = 0;
  for (let i = 0; i < line; i++) {
    const next = text.indexOf("\n", start);
    if (next < 0) return text.length;
    start = next + 1;
  }
  const end = text.indexOf("\n", start);
  return Math.min(start + character, end < 0 ? text.length : end);
}

/** What a client said, without the texts that it replaced since. */
export class Documents {
  #initialize;
  #settings;
  /** What changed in the files of the workspace since `initialize`. */
  #files = new Map();
  #open = new Map();

  /** Takes a message of the client. Returns whether a text changed. */
  take({ id, method, params }) {
    switch (method) {
      case "initialize":
        this.#initialize = { id, params };
        return false;
      case "workspace/didChangeConfiguration":
        this.#settings = params;
        return true;
      case "shaderlint/files":
        for (const file of params.files) this.#files.set(file.uri, file);
        return true;
      case "textDocument/didOpen":
        this.#open.set(params.textDocument.uri, { ...params.textDocument });
        return true;
      case "textDocument/didChange": {
        const document = this.#open.get(params.textDocument.uri);
        if (!document) return false;
        document.version = params.textDocument.version;
        for (const { range, text } of params.contentChanges) {
          const old = document.text;
          document.text = range
            ? old.slice(0, offset(old, range.start)) + text + old.slice(offset(old, range.end))
            : text;
        }
        return true;
      }
      case "textDocument/didClose":
        this.#open.delete(params.textDocument.uri);
        return false;
      default:
        return false;
    }
  }

  /** The messages for another server. Its answer to `initialize` is known already. */
  *replay() {
    if (!this.#initialize) return;
    const of = (method, params) => ({ jsonrpc: "2.0", method, params });
    yield { ...of("initialize", this.#initialize.params), id: this.#initialize.id };
    yield of("initialized", {});
    if (this.#settings) yield of("workspace/didChangeConfiguration", this.#settings);
    if (this.#files.size > 0) yield of("shaderlint/files", { files: [...this.#files.values()] });
    for (const textDocument of this.#open.values()) {
      yield of("textDocument/didOpen", { textDocument: { ...textDocument } });
    }
  }
}

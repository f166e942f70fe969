// The language server answers while shaders run, and continues after a worker was replaced.

import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";
import { startServer } from "./load.js";

/** A worker of Node with the interface of a web worker; counts how many were started. */
function workers() {
  const started = [];
  const create = () => {
    const file = pathToFileURL(path.join(process.env.WASM, "node-worker.js"));
    const worker = new Worker(file);
    const port = {
      postMessage: (message) => worker.postMessage(message),
      terminate: () => worker.terminate(),
      onmessage: undefined,
    };
    worker.on("message", (data) => port.onmessage({ data }));
    started.push(port);
    return port;
  };
  return { create, started };
}

/** A client of the server. */
class Client {
  #server;
  #next = 0;
  #wanted = [];
  received = [];

  static async start(options) {
    const client = new Client();
    client.#server = await startServer(options);
    client.#server.subscribe((text) => client.#take(JSON.parse(text)));
    await client.request("initialize", { processId: null, capabilities: {}, rootUri: null });
    client.notify("initialized", {});
    return client;
  }

  #take(message) {
    this.received.push(message);
    this.#wanted = this.#wanted.filter(({ is, resolve }) => !is(message) || resolve(message));
  }

  /** The next message that fits. */
  next(is) {
    return new Promise((resolve) => this.#wanted.push({ is, resolve }));
  }

  notify(method, params) {
    this.#server.send(JSON.stringify({ jsonrpc: "2.0", method, params }));
  }

  request(method, params) {
    const id = ++this.#next;
    const answered = this.next((message) => message.id === id && message.method === undefined);
    this.#server.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
    return answered;
  }

  /** Opens a document and returns its first findings. */
  open(uri, text) {
    const findings = this.next((m) => m.method === "textDocument/publishDiagnostics");
    const textDocument = { uri, languageId: "glsl", version: 1, text };
    this.notify("textDocument/didOpen", { textDocument });
    return findings;
  }

  close() {
    this.#server.close();
  }
}

/** A shader that a sample run finds to be black. */
const DARK = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 n = normalize(vec3(uv, -1.0));
    float sun = max(0.0, dot(n, normalize(vec3(0.0, 0.0, 1.0))));
    fragColor = vec4(vec3(0.9, 0.5, 0.2) * sun, 1.0);
}
`;
const URI = "file:///image.glsl";
const rules = (message) => message.params.diagnostics.map((d) => d.code);

test("errors arrive immediately and sampling results after a pause", async (t) => {
  const { create } = workers();
  const client = await Client.start({ worker: create, pause: 1 });
  t.after(() => client.close());
  const first = await client.open(URI, DARK);
  assert.deepEqual(rules(first), []);
  const second = await client.next((m) => m.method === "textDocument/publishDiagnostics");
  assert.deepEqual(rules(second), ["dark-frame"]);
  const range = { start: { line: 1, character: 4 }, end: { line: 1, character: 8 } };
  client.notify("textDocument/didChange", {
    textDocument: { uri: URI, version: 2 },
    contentChanges: [{ range, text: "vec3" }],
  });
  const third = await client.next((m) => m.params?.version === 2);
  assert.ok(rules(third).includes("vector-size"), rules(third).join());
});

test("a worker that is busy with a sample run is replaced", async (t) => {
  const { create } = workers();
  let busy;
  const isBusy = new Promise((resolve) => (busy = resolve));
  let count = 0;
  /** The first worker never ends its run, and reads nothing after it. */
  const worker = () => {
    const port = create();
    const post = port.postMessage;
    const take = (data) => {
      if (!data.run) return post(data);
      port.postMessage = () => {};
      return busy();
    };
    if (++count === 1) port.postMessage = take;
    return port;
  };
  const client = await Client.start({ worker, pause: 1 });
  t.after(() => client.close());
  await client.open(URI, DARK);
  const other = (text) => ({ files: [{ uri: "file:///lib.glsl", text }] });
  client.notify("shaderlint/files", other("float lost;\n"));
  client.notify("shaderlint/files", other("float kept;\n"));
  await isBusy;
  const ran = client.next((m) => m.params?.diagnostics?.length > 0);
  const position = { line: 1, character: 9 };
  const hover = await client.request("textDocument/hover", { textDocument: { uri: URI }, position });
  assert.match(JSON.stringify(hover.result), /vec2 uv/);
  assert.deepEqual(rules(await ran), ["dark-frame"]);
  // The other worker has the files too.
  await client.open("file:///user.glsl", '#include "lib.glsl"\nfloat f() { return kept; }\n');
  const use = { textDocument: { uri: "file:///user.glsl" }, position: { line: 1, character: 20 } };
  const found = await client.request("textDocument/definition", use);
  assert.match(JSON.stringify(found.result), /lib\.glsl/);
});

test("a request that crashes the module gets an answer", async (t) => {
  const { create } = workers();
  let count = 0;
  const worker = () => {
    const port = create();
    const post = port.postMessage;
    const crash = "internal error";
    // As if the module trapped.
    port.postMessage = (data) =>
      count === 1 && data.message?.method === "textDocument/hover"
        ? port.onmessage({ data: { number: data.number, crash } })
        : post(data);
    count += 1;
    return port;
  };
  const client = await Client.start({ worker, pause: 1e6 });
  t.after(() => client.close());
  await client.open(URI, "float f(float x) { return x; }\n");
  const params = { textDocument: { uri: URI }, position: { line: 0, character: 26 } };
  count = 1;
  const failed = await client.request("textDocument/hover", params);
  assert.equal(failed.error.message, "internal error");
  count = 2;
  const hover = await client.request("textDocument/hover", params);
  assert.match(JSON.stringify(hover.result), /float x/);
});

// The language server in a worker. `port` is the worker's own scope, or a port with the same methods.

import { Shaderlint } from "./index.js";

/** Serves the client at `port`, which sends the compiled module first. */
export function serve(port) {
  let server;
  port.onmessage = ({ data }) => {
    if (data.module) {
      server = new Shaderlint(data.module);
      return;
    }
    const { number } = data;
    try {
      const messages = data.run ? server.runChanged() : server.lsp(data.message);
      port.postMessage({ number, messages });
    } catch (error) {
      // The instance was replaced and knows no document any more.
      port.postMessage({ number, crash: error.message });
    }
  };
}

// The language server as a worker of Node.

import { parentPort } from "node:worker_threads";
import { serve } from "./serve.js";

const port = { postMessage: (message) => parentPort.postMessage(message), onmessage: undefined };
parentPort.on("message", (data) => port.onmessage({ data }));
serve(port);

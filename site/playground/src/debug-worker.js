// The debugger in a worker: messages of the Debug Adapter Protocol in, messages out.
import { Shaderlint, portAddress } from '../wasm/index.js';

const loading = Shaderlint.load(portAddress());

self.onmessage = async ({ data: { messages, isCounted } }) => {
  try {
    const shaderport = await loading;
    const answers = messages.flatMap((message) => shaderport.debug(message));
    self.postMessage({ answers: isCounted ? [...answers, ...shaderport.debugIdle()] : answers });
  } catch (error) {
    self.postMessage({ error: error.message });
  }
};

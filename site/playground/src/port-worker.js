// Ports shaders for the image, beside the language server.
import { Shaderlint, portAddress } from '../wasm/index.js';

const loading = Shaderlint.load(portAddress());

self.onmessage = async ({ data: { number, name, text } }) => {
  try {
    const shaderport = await loading;
    self.postMessage({ number, ...shaderport.playerData(text, { name }) });
  } catch (error) {
    self.postMessage({ number, errors: 1, reason: error.message });
  }
};

// Ports shaders for the image, beside the language server.
import { Shaderlint, portAddress } from '../wasm/index.js';
import { shaderOf } from './shader.js';

const loading = Shaderlint.load(portAddress());

self.onmessage = async ({ data: { number, files } }) => {
  try {
    const shaderport = await loading;
    self.postMessage({ number, ...shaderport.request('playerData', shaderOf(files)) });
  } catch (error) {
    self.postMessage({ number, errors: 1, reason: error.message });
  }
};

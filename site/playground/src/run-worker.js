// Draws shaders on the processor and traces pixels, beside the language server and the image.
import { Shaderlint, portAddress } from '../wasm/index.js';
import { shaderOf } from './shader.js';

const loading = Shaderlint.load(portAddress());

self.onmessage = async ({ data: { files, other, options } }) => {
  try {
    const shaderport = await loading;
    const compare = other && shaderOf(other);
    self.postMessage({ result: shaderport.request('run', { ...shaderOf(files), ...options, compare }) });
  } catch (error) {
    self.postMessage({ error: error.message });
  }
};

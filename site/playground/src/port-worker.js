// Ports shaders for the image, beside the language server.
import { Shaderlint, portAddress } from '../wasm/index.js';
import { readChannels } from './channels.js';
import { CHANNELS, isFolder } from './passes.js';

const loading = Shaderlint.load(portAddress());

/** The data for the player. @param {import('./passes.js').Files} files */
function dataOf(shaderport, files) {
  if (!isFolder(files)) {
    const [[name, text]] = Object.entries(files);
    return shaderport.playerData(text, { name });
  }
  const { [CHANNELS]: table, ...passes } = files;
  const channels = [...readChannels(table)].map(([channel, source]) => `${channel}=${source}`);
  return shaderport.playerData('', { name: 'shader', passes, channels });
}

self.onmessage = async ({ data: { number, files } }) => {
  try {
    const shaderport = await loading;
    self.postMessage({ number, ...dataOf(shaderport, files) });
  } catch (error) {
    self.postMessage({ number, errors: 1, reason: error.message });
  }
};

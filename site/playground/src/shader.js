// Files as the module takes them.
import { readChannels } from './channels.js';
import { CHANNELS, isFolder } from './passes.js';

/** The parameters of a request about files. @param {import('./passes.js').Files} files */
export function shaderOf(files) {
  if (!isFolder(files)) {
    const [[name, text]] = Object.entries(files);
    return { name, text };
  }
  const { [CHANNELS]: table, ...passes } = files;
  const channels = [...readChannels(table)].map(([channel, source]) => `${channel}=${source}`);
  return { name: 'shader', passes, channels };
}

// What the channels of passes read, as the file `channels.toml` that the command line reads in a folder of
// passes.

/** Inputs that are not passes. */
export const DEVICES = { keyboard: 'Keyboard', webcam: 'Camera', mic: 'Microphone' };

/** The passes with channels, by file without extension. */
export const hasChannels = (file) => /^(image|buffer_[a-d]|cubemap)\.glsl$/.test(file);

/** A channel such as `image.0` with what it reads, such as `buffer_a,nearest`. @typedef {Map<string, string>} Channels */

/**
 * Reads the tables that `writeChannels` writes. Other lines are skipped.
 * @param {string} [text]
 * @returns {Channels}
 */
export function readChannels(text = '') {
  const channels = new Map();
  let pass = 'image';
  for (const line of text.split('\n')) {
    const table = /^\s*\[(\w+)\]/.exec(line);
    if (table) pass = table[1];
    const entry = /^\s*([0-3])\s*=\s*["']([^"']*)["']/.exec(line);
    if (entry) channels.set(`${pass}.${entry[1]}`, entry[2]);
  }
  return channels;
}

/** @param {Channels} channels */
export function writeChannels(channels) {
  const passes = Map.groupBy([...channels].sort(), ([channel]) => channel.split('.')[0]);
  return [...passes].map(([pass, entries]) => {
    const lines = entries.map(([channel, source]) => `${channel.split('.')[1]} = "${source}"\n`);
    return `[${pass}]\n${lines.join('')}`;
  }).join('\n');
}

/** The channels of passes that exist, and read passes that exist. @param {Channels} channels @param {string[]} files */
export function existing(channels, files) {
  const isThere = (pass) => files.includes(`${pass}.glsl`);
  return new Map([...channels].filter(([channel, source]) => {
    const [input] = source.split(',');
    return isThere(channel.split('.')[0]) && (input in DEVICES || isThere(input));
  }));
}

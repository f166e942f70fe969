// Links that contain a shader: after `#code=` the UTF-8 text of the only file, or of a JSON object with the
// texts of several files by name, compressed with raw deflate, as base64url without padding. An export of
// ShaderToy is JSON too, but its keys are not file names. `debug-link.js` reads what may follow.
import { readText } from './limit.js';
import { single } from './passes.js';

async function compressed(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Files as one text. A single text without a name that matters stays as it is. @param {import('./passes.js').Files} files */
function packed(files) {
  const texts = Object.values(files);
  const isPlain = texts.length === 1 && Object.keys(files)[0] === Object.keys(single(texts[0]))[0];
  return isPlain ? texts[0] : JSON.stringify(files);
}

/** The files in a text. @param {string} text @returns {import('./passes.js').Files} */
function unpacked(text) {
  if (!text.startsWith('{"')) return single(text);
  let files;
  try {
    files = JSON.parse(text);
  } catch {
    return single(text);
  }
  const entries = Object.entries(files);
  const isFile = ([name, content]) => /^[\w-]+(\.[\w-]+)+$/.test(name) && typeof content === 'string';
  return entries.length > 0 && entries.every(isFile) ? files : single(text);
}

/** The fragment of a link to files. @param {import('./passes.js').Files} files */
export async function fragmentOf(files) {
  const bytes = await compressed(packed(files));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return `#code=${base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** The files in the fragment of a link; null if there are none. @param {string} fragment */
export async function filesOf(fragment) {
  const found = /^#code=([\w-]+)(?:&|$)/.exec(fragment);
  if (!found) return null;
  const base64 = found[1].replaceAll('-', '+').replaceAll('_', '/');
  const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0));
  return unpacked(await readText(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))));
}

// Addresses of the playground that open a shader in it.
import zlib from 'node:zlib';
import { base } from './address.js';

/**
 * Raw deflate as base64url without padding, after `#code=`. The playground reads the same form: a text, or an
 * object with texts by file name if the name of the file matters.
 */
export function playground(code, file) {
  const text = file ? JSON.stringify({ [file]: code }) : code;
  return `${base}playground/#code=${zlib.deflateRawSync(text, { level: 9 }).toString('base64url')}`;
}

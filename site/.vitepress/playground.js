// Addresses of the playground that open a shader in it.
import zlib from 'node:zlib';
import { base } from './address.js';

/** Raw deflate as base64url without padding, after `#code=`. The playground reads the same form. */
export const playground = (code) => `${base}playground/#code=${zlib.deflateRawSync(code, { level: 9 }).toString('base64url')}`;

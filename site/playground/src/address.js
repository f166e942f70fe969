// Shaders at an address: `#url=https://example.org/shader.frag`. The address decides on a text in the editor
// and on nothing else.
import { readText } from './limit.js';
import { single } from './passes.js';

const LOCAL = ['localhost', '127.0.0.1'];

/** Extensions that say what a text is. */
const NAMED = /^[\w-]+\.(glsl|frag|vert|fs|vs|html|json)$/;

/** The address in the fragment of a link; null if there is none. @param {string} fragment */
export function addressIn(fragment) {
  const found = /^#url=(.+)$/.exec(fragment)?.[1];
  if (!found) return null;
  const text = /^https?%3A/i.test(found) ? decodeURIComponent(found) : found;
  if (!URL.canParse(text)) throw new Error('the address is not valid');
  const url = new URL(text);
  const isLocal = url.protocol === 'http:' && LOCAL.includes(url.hostname);
  if (url.protocol !== 'https:' && !isLocal) throw new Error('the address must begin with https://');
  return url;
}

/**
 * The file at an address.
 * @param {URL} url
 * @returns {Promise<import('./passes.js').Files>}
 */
export async function filesAt(url) {
  let response;
  try {
    response = await fetch(url, { credentials: 'omit', referrerPolicy: 'no-referrer', redirect: 'follow' });
  } catch {
    throw new Error(`${url.hostname} cannot be reached, or does not allow other sites to read it (CORS)`);
  }
  if (!response.ok) throw new Error(`${url.hostname} answered with status ${response.status}`);
  const text = await readText(response.body ?? new Blob([]).stream());
  const name = url.pathname.split('/').at(-1);
  return NAMED.test(name) ? { [name]: text } : single(text);
}

// Links that contain a shader: raw deflate as base64url after `#code=`.

/** A link to a longer text is not opened: what it inflates to must not fill the memory. */
const MOST = 1 << 20;

async function through(bytes, stream) {
  const chunks = [];
  let size = 0;
  for await (const chunk of new Blob([bytes]).stream().pipeThrough(stream)) {
    size += chunk.length;
    if (size > MOST) throw new Error('the shader in the link is longer than 1 MB');
    chunks.push(chunk);
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

/** The fragment of a link to a text. */
export async function fragmentOf(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return `#code=${base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** The text in the fragment of a link; null if there is none. */
export async function textOf(fragment) {
  const found = /^#code=([\w-]+)$/.exec(fragment);
  if (!found) return null;
  const base64 = found[1].replaceAll('-', '+').replaceAll('_', '/');
  const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0));
  const text = await through(bytes, new DecompressionStream('deflate-raw'));
  return new TextDecoder('utf-8', { fatal: true }).decode(text);
}

// Texts from elsewhere: what a link inflates to, or an address sends, must not fill the memory.

/** The most bytes of a text that a link may open. */
const MOST = 1 << 20;

/** The text of a stream, which must be UTF-8 and not longer than a shader. @param {ReadableStream<Uint8Array>} stream */
export async function readText(stream) {
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let size = 0;
  let text = '';
  // Leaving the loop cancels the stream.
  for await (const chunk of chunksOf(stream)) {
    size += chunk.length;
    if (size > MOST) throw new Error('the shader is longer than 1 MB');
    text += decode(decoder, chunk);
  }
  text += decode(decoder);
  if (text.includes('\0')) throw new Error('this is not a text');
  return text;
}

/** @param {TextDecoder} decoder @param {Uint8Array} [chunk] */
function decode(decoder, chunk) {
  try {
    return decoder.decode(chunk, { stream: chunk !== undefined });
  } catch {
    throw new Error('this is not a text in UTF-8');
  }
}

/** The chunks of a stream, in browsers that cannot iterate over it too. */
async function* chunksOf(stream) {
  const reader = stream.getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      yield value;
    }
  } finally {
    reader.cancel().catch(() => {});
  }
}

// Writes WebM files from encoded chunks.

/** @typedef {{track: number, time: number, isKey: boolean, data: Uint8Array}} FilmChunk time in milliseconds */
/** @typedef {{codec: string, width: number, height: number}} VideoTrack */
/** @typedef {{codec: string, rate: number, channels: number, head: Uint8Array}} AudioTrack */

/** @param {...(Uint8Array | number[])} parts */
function bytes(...parts) {
  const out = new Uint8Array(parts.reduce((sum, p) => sum + p.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** An integer in a number of bytes, big-endian. @param {number} value @param {number} count */
function wholeNumber(value, count) {
  return Array.from({ length: count }, (_, i) => Math.floor(value / 256 ** (count - 1 - i)) % 256);
}

/** @param {number} value */
function realNumber(value) {
  const out = new Uint8Array(8);
  new DataView(out.buffer).setFloat64(0, value);
  return out;
}

/** An EBML element: its id, its length in eight bytes, its content. @param {number} id @param {...(Uint8Array | number[])} parts */
function box(id, ...parts) {
  const inside = bytes(...parts);
  const number = wholeNumber(id, id > 0xffffff ? 4 : id > 0xffff ? 3 : id > 0xff ? 2 : 1);
  return bytes(number, [1, ...wholeNumber(inside.length, 7)], inside);
}

/** @param {string} text */
function letters(text) {
  return new TextEncoder().encode(text);
}

/** @param {VideoTrack} video @param {AudioTrack | null} audio */
function tracks(video, audio) {
  const common = (/** @type {number} */ number, /** @type {number} */ type, /** @type {string} */ codec) => bytes(
    box(0xd7, [number]), box(0x73c5, [number]), box(0x9c, [0]), box(0x83, [type]), box(0x86, letters(codec)),
  );
  const picture = box(0xe0, box(0xb0, wholeNumber(video.width, 2)), box(0xba, wholeNumber(video.height, 2)));
  const entries = [box(0xae, common(1, 1, video.codec), picture)];
  if (audio) {
    const sound = box(0xe1, box(0xb5, realNumber(audio.rate)), box(0x9f, [audio.channels]));
    // Codec delay and seek pre-roll of Opus, in nanoseconds.
    const start = bytes(box(0x56aa, wholeNumber(6500000, 4)), box(0x56bb, wholeNumber(80000000, 4)));
    entries.push(box(0xae, common(2, 2, audio.codec), start, box(0x63a2, audio.head), sound));
  }
  return box(0x1654ae6b, ...entries);
}

/** Groups chunks into clusters that start with a key frame. @param {FilmChunk[]} chunks */
function clusters(chunks) {
  /** @type {FilmChunk[][]} */
  const groups = [];
  for (const chunk of chunks) {
    const last = groups[groups.length - 1];
    // Times within a cluster have 16 bits.
    if (!last || (chunk.track === 1 && chunk.isKey) || chunk.time - last[0].time > 30000) groups.push([chunk]);
    else last.push(chunk);
  }
  return groups.map((group) => {
    const start = Math.round(group[0].time);
    const blocks = group.map((c) => box(0xa3, [0x80 | c.track], wholeNumber((Math.round(c.time) - start) & 0xffff, 2), [c.isKey ? 0x80 : 0], c.data));
    return { start, data: box(0x1f43b675, box(0xe7, wholeNumber(start, 4)), ...blocks) };
  });
}

/** Builds the file. @param {VideoTrack} video @param {AudioTrack | null} audio @param {FilmChunk[]} chunks @param {number} duration milliseconds */
function webm(video, audio, chunks, duration) {
  const head = box(0x1a45dfa3, box(0x4286, [1]), box(0x42f7, [1]), box(0x42f2, [4]), box(0x42f3, [8]), box(0x4282, letters('webm')), box(0x4287, [4]), box(0x4285, [2]));
  const info = box(0x1549a966, box(0x2ad7b1, wholeNumber(1000000, 4)), box(0x4d80, letters('shaderport')), box(0x5741, letters('shaderport')), box(0x4489, realNumber(duration)));
  const all = clusters([...chunks].sort((a, b) => a.time - b.time || a.track - b.track));
  const body = tracks(video, audio);
  /** Positions of the clusters, for seeking. @param {number} from */
  const cues = (from) => {
    let at = from;
    return box(0x1c53bb6b, ...all.map(({ start, data }) => {
      const point = box(0xbb, box(0xb3, wholeNumber(start, 4)), box(0xb7, box(0xf7, [1]), box(0xf1, wholeNumber(at, 8))));
      at += data.length;
      return point;
    }));
  };
  const before = info.length + body.length;
  const index = cues(before + cues(0).length);
  const length = before + index.length + all.reduce((sum, c) => sum + c.data.length, 0);
  const segment = bytes(wholeNumber(0x18538067, 4), [1, ...wholeNumber(length, 7)]);
  return new Blob([head, segment, info, body, index, ...all.map((c) => c.data)], { type: 'video/webm' });
}

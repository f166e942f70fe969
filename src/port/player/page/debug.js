// Debug: opens the playground at a pixel of this image. The shader is in the fragment of the address, which no
// server receives.

/** What channels of the playground read, apart from passes. */
const DEBUG_DEVICES = ['keyboard', 'webcam', 'mic'];

/** The names of the passes in the playground. @param {PassData[]} passes */
function debugNames(passes) {
  const free = ['a', 'b', 'c', 'd'];
  return passes.map(({ kind, name }) => {
    if (kind !== 'buffer') return kind;
    const own = free.findIndex((letter) => name.toLowerCase().endsWith(` ${letter}`));
    return `buffer_${free.splice(Math.max(own, 0), 1)}`;
  });
}

/** What the channels of the passes read, as `channels.toml`. Files stay in this page. @param {PassData[]} passes @param {string[]} names */
function debugChannels(passes, names) {
  const tables = passes.map(({ inputs }, at) => {
    const lines = inputs.map((input, slot) => {
      const { kind = '', buffer = -1, filter, wrap } = input ?? {};
      const read = kind === 'cubebuffer' ? 'cubemap' : names[buffer];
      if (read) return `${slot} = "${read},${filter},${wrap}"\n`;
      return DEBUG_DEVICES.includes(kind) ? `${slot} = "${kind}"\n` : '';
    });
    return lines.join('') && `[${names[at]}]\n${lines.join('')}`;
  });
  return tables.filter(Boolean).join('\n');
}

/** The shader as the playground opens it: a text, or its files by name as JSON. @param {ProjectData} project */
function debugText({ files, passes }) {
  const shown = files.filter((file) => !file.hidden);
  if (passes.some((pass) => pass.uniforms)) return shown[0].text;
  const names = debugNames(passes);
  /** @type {Record<string, string>} */
  const texts = {};
  passes.forEach((pass, at) => {
    // What the passes share comes before the text of each.
    const own = pass.files.map((index) => files[index]).filter((file) => !file.hidden);
    const last = own.pop();
    if (own.length > 0) texts['common.glsl'] = own.map((file) => file.text).join('\n');
    texts[`${names[at]}.glsl`] = last?.text ?? '';
  });
  const channels = debugChannels(passes, names);
  if (channels) texts['channels.toml'] = channels;
  return Object.keys(texts).length > 1 ? JSON.stringify(texts) : shown[0].text;
}

/** Raw deflate as base64url without padding. @param {string} text */
async function deflated(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * Opens the debugger of the playground.
 * @param {Player} player
 * @param {{x: number, y: number} | null} place of its pixel; by default that of the last click, or the middle
 */
async function openDebugger(player, place) {
  const { canvas: { width, height }, clock, mouse, controls, project } = player;
  const at = (/** @type {number} */ value, /** @type {number} */ most) => Math.min(Math.max(0, Math.floor(value)), most - 1);
  const isPressed = mouse.clickX !== 0 || mouse.clickY !== 0;
  const { x, y } = place ?? (isPressed ? mouse : { x: width / 2, y: height / 2 });
  const words = [
    `code=${await deflated(debugText(project))}`,
    'debug',
    `pixel=${at(x, width)},${at(y, height)}`,
    `size=${width}x${height}`,
    `time=${clock.time}`,
    `frame=${clock.shown}`,
    ...(isPressed ? [`mouse=${mouse.x},${mouse.y}`] : []),
    ...[...controls].map(([name, value]) => `u.${name}=${value.join()}`),
  ];
  window.open(`${element('debug', HTMLElement).dataset.playground}#${words.join('&')}`, '_blank', 'noopener');
}

SHORTCUTS.push({ keys: ['d', 'D'], shown: 'd', words: 'Debug the pixel under the mouse, in the playground', act: (player) => void openDebugger(player, player.mouse.place) });

/** @param {Player} player */
pageParts.showDebug = (player) => element('debug', HTMLElement).addEventListener('click', () => void openDebugger(player, null));

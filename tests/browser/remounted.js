// A canvas whose player is disposed and mounted again, also around the loss of its context.
import assert from 'node:assert/strict';
import { put, shaderport } from './browser.js';
import { host } from './modules.js';

const sampler = { filter: 'linear', wrap: 'repeat', vflip: 'true' };
const input = (channel, type, id) => ({ id, type, channel, sampler });
const image = (code, ...inputs) => ({ type: 'image', code, inputs, outputs: [{ id: '37', channel: 0 }] });
const FEEDBACK = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U / iResolution.xy) * 0.5 + vec4(U / 64.0, float(iFrame + 1) / 9.0, 1); }';
const buffer = { type: 'buffer', code: FEEDBACK, inputs: [input(0, 'buffer', '4dXGR8')], outputs: [{ id: '4dXGR8', channel: 0 }] };
const FACES = 'void mainCubemap(out vec4 O, vec2 U, vec3 o, vec3 d) { O = vec4(abs(d), 1); }';
const cube = { type: 'cubemap', code: FACES, inputs: [], outputs: [{ id: '4dX3Rr', channel: 0 }] };
const READ = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U / iResolution.xy); }';
const AROUND = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, vec3(U / iResolution.xy - 0.5, 0.5)); }';

/** By what they hold of a context. */
const PROJECTS = {
  program: [image('void mainImage(out vec4 O, vec2 U) { O = vec4(U / iResolution.xy, float(iFrame) / 9.0, 1); }')],
  buffers: [buffer, image(READ, input(0, 'buffer', '4dXGR8'))],
  'cube map': [cube, image(AROUND, input(0, 'cubemap', '4dX3Rr'))],
  picture: [image(READ, input(0, 'texture', 'Xsf3zn'))],
  volume: [image(AROUND, input(0, 'volume', '4sfGRr'))],
  keyboard: [image(READ, input(0, 'keyboard', '4dXGRr'))],
  music: [image(READ, input(0, 'music', '4sXGzn'))],
};

/** Draws frame 1 in turn with new players, and after its context was lost; runs in the page. */
async function remount(mount) {
  const canvas = document.querySelector('canvas');
  const gl = () => canvas.getContext('webgl2');
  const seen = [];
  const draw = async (shader, when) => {
    await shader.renderFrame(1);
    const bytes = new Uint8Array(64 * 36 * 4);
    gl().readPixels(0, 0, 64, 36, gl().RGBA, gl().UNSIGNED_BYTE, bytes);
    seen.push({ when, error: gl().getError(), image: bytes.toBase64(), said: shader.errors });
  };
  const start = () => mount(canvas, { size: [64, 36], paused: true });
  const told = (name) => new Promise((resolve) => { canvas.addEventListener(name, () => requestAnimationFrame(resolve), { once: true }); });
  const lose = async () => {
    const extension = gl().getExtension('WEBGL_lose_context');
    const lost = told('webglcontextlost');
    extension.loseContext();
    await lost;
    return extension;
  };
  const restore = async (extension) => {
    const restored = told('webglcontextrestored');
    extension.restoreContext();
    await restored;
  };
  let shader = start();
  await draw(shader, 'first');
  shader.dispose();
  shader = start();
  await draw(shader, 'mounted again');
  await restore(await lose());
  await draw(shader, 'restored');
  const extension = await lose();
  shader.dispose();
  await restore(extension);
  shader = start();
  await draw(shader, 'mounted after a loss');
  shader.dispose();
  return seen;
}

async function again(context, kind) {
  const file = put('again.json', JSON.stringify({ info: {}, renderpass: PROJECTS[kind] }));
  const { code, stderr } = await shaderport(file, '-o', 'again.js', '--force');
  assert.equal(code, 0, stderr);
  const { page, until } = await host(context, `
    import { mount } from './again.js';
    globalThis.seen = await (${remount})(mount);`);
  await until(() => globalThis.seen);
  const [first, ...others] = await page.evaluate(() => globalThis.seen);
  assert.deepEqual([first.error, first.said], [0, []]);
  for (const other of others) {
    assert.deepEqual([other.error, other.said], [0, []], other.when);
    assert.ok(other.image === first.image, `${other.when}: another image`);
  }
}

export const remountTests = Object.keys(PROJECTS).map((kind) => ({
  name: `remount: ${kind}`,
  only: kind === 'cube map' ? 'heavy' : undefined,
  run: (context) => again(context, kind),
}));

// The page in use.
import assert from 'node:assert/strict';
import path from 'node:path';
import { colors, differences, frame, frames, open, pixels, port, put, top } from './browser.js';
import { shader } from './cases.js';
import { codeTests } from './page/code.js';
import { controlTests } from './page/controls.js';
import { embedTests } from './page/embed.js';
import { exportTests } from './page/export.js';
import { inputTests } from './page/input.js';
import { layoutTests } from './page/layout.js';
import { mediaTests } from './page/media.js';
import { desk, MOVING, picture, playing, show, time } from './page/show.js';

async function playAndPause(context) {
  const { page } = await show(context, 'play', MOVING, '#scale=0.25');
  assert.ok(await playing(page));
  const isLater = (moment) => page.waitForFunction((t) => globalThis.shaderport.player.clock.time > t, moment);
  await isLater(0);
  await page.click('#play');
  assert.ok(!(await playing(page)));
  // No test runs that long: a smaller value means a restart.
  await page.evaluate(() => globalThis.shaderport.seek(1e6));
  const still = await pixels(page);
  await frames(page);
  assert.equal(await time(page), 1e6);
  assert.equal(differences(await pixels(page), still), 0);
  await page.click('#play');
  await isLater(1e6);
  await page.click('#restart');
  assert.ok((await time(page)) < 1e6);
  await page.waitForFunction(() => /^[\d.]+ fps$/.test(document.querySelector('#rate').textContent));
}

async function scrub(context) {
  const { page } = await show(context, 'scrub', MOVING, '#size=64x36&paused');
  const before = await pixels(page);
  await page.fill('#scrub', '12.35');
  assert.equal(await time(page), 12.35);
  await page.waitForFunction(() => document.querySelector('#time').textContent === '12.35');
  assert.ok(differences(await pixels(page), before) > 0);
}

async function address(context) {
  const { page } = await show(context, 'address', MOVING, '#size=320x180&t=2.5&paused');
  assert.deepEqual(await page.evaluate(() => {
    const { canvas, clock, isPlaying } = globalThis.shaderport.player;
    return [canvas.width, canvas.height, clock.time, isPlaying];
  }), [320, 180, 2.5, false]);
  assert.ok(colors(await pixels(page)) > 10);
}

async function mouse(context) {
  const code = `void mainImage(out vec4 O, vec2 U) {
  O = vec4(iMouse.xy / iResolution.xy, 0.5 + 0.25 * sign(iMouse.zw));
  O = vec4(O.x, O.y, O.z, 1.0); }`;
  const { page } = await show(context, 'mouse', code, '#paused');
  const value = () => page.evaluate(() => globalThis.shaderport.player.mouse.value());
  const box = await page.locator('canvas').boundingBox();
  await page.mouse.move(100, 50);
  await page.mouse.down();
  await page.mouse.move(120, 80);
  assert.deepEqual(await value(), [120, box.height - 80, 100, -(box.height - 50)]);
  await page.mouse.up();
  await page.mouse.move(10, 10);
  assert.deepEqual(await value(), [120, box.height - 80, -100, -(box.height - 50)]);
}

async function touch(context) {
  const { page } = await show(context, 'touch', MOVING, '#paused');
  await page.touchscreen.tap(60, 40);
  const [x, y, z] = await page.evaluate(() => globalThis.shaderport.player.mouse.value());
  const [height, scale] = await page.evaluate(() => {
    const { canvas } = globalThis.shaderport.player;
    return [canvas.clientHeight, canvas.width / canvas.clientWidth];
  });
  assert.deepEqual([x, y, Math.sign(z)], [60 * scale, (height - 40) * scale, -1]);
}

async function keyboard(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = vec4(texelFetch(iChannel0, ivec2(65, 0), 0).x, texelFetch(iChannel0, ivec2(65, 2), 0).x, 0.0, 1.0); }';
  const { page } = await show(context, 'keys', code, '#size=32x18&paused', '--channel', '0=keyboard');
  const color = async () => (await pixels(page)).slice(0, 2);
  await page.keyboard.press('a');
  assert.deepEqual(await color(), [0, 0], 'keys count only while the canvas has the focus');
  await page.focus('canvas');
  await page.keyboard.down('a');
  assert.deepEqual(await color(), [255, 255]);
  await page.keyboard.up('a');
  assert.deepEqual(await color(), [0, 255]);
  await page.keyboard.press('a');
  assert.deepEqual(await color(), [0, 0]);
}

async function resize(context) {
  const toy = shader(
    { type: 'image', name: '', inputs: [{ id: '4dXGR8', type: 'buffer', channel: 0, sampler: { filter: 'nearest', wrap: 'clamp' } }], outputs: [],
      code: 'void mainImage(out vec4 O, vec2 U) { O = texelFetch(iChannel0, ivec2(U), 0); }' },
    { type: 'buffer', name: '', inputs: [{ id: '4dXGR8', type: 'buffer', channel: 0, sampler: { filter: 'nearest', wrap: 'clamp' } }], outputs: [{ id: '4dXGR8' }],
      code: 'void mainImage(out vec4 O, vec2 U) { O = iFrame == 0 ? vec4(1.0, 0.0, 0.0, 1.0) : texelFetch(iChannel0, ivec2(U), 0); }' },
  );
  const { page } = await show(context, 'resize', toy, '#paused');
  await page.setViewportSize({ width: 1200, height: 600 });
  await page.waitForFunction(() => globalThis.shaderport.player.canvas.width === 1200);
  const { width, bytes } = await page.evaluate(() => {
    globalThis.shaderport.player.poke();
    const { canvas, gl } = globalThis.shaderport.player;
    const row = new Uint8Array(canvas.width * 4);
    gl.readPixels(0, 5, canvas.width, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
    return { width: canvas.width, bytes: Array.from(row) };
  });
  assert.equal(width, 1200);
  assert.deepEqual(bytes.slice(4 * 990, 4 * 990 + 3), [255, 0, 0], 'existing content stays');
  assert.deepEqual(bytes.slice(4 * 1010, 4 * 1010 + 3), [0, 0, 0], 'the new area is empty');
  await page.selectOption('#scale', '0.5');
  assert.equal(await page.evaluate(() => globalThis.shaderport.player.canvas.width), 600);
}

async function sound(context) {
  const toy = shader(
    { type: 'image', name: '', inputs: [], outputs: [], code: 'void mainImage(out vec4 O, vec2 U) { O = vec4(U.x); }' },
    { type: 'sound', name: '', inputs: [], outputs: [], code: 'vec2 mainSound(in int s, float t) { return vec2(sin(6.2831 * 440.0 * t), float(s % 100) / 100.0); }' },
  );
  const { page } = await show(context, 'sound', toy, '#size=32x18');
  await page.click('#sound');
  assert.equal(await page.getAttribute('#sound', 'aria-pressed'), 'true');
  await page.waitForFunction(() => globalThis.shaderport.player.sound?.source);
  const samples = await page.evaluate(() => {
    const { left, right } = globalThis.shaderport.player.sound;
    // The second block starts at sample 262144.
    return [25, 1000, 262144 + 50].map((i) => [left[i], right[i]]);
  });
  for (const [i, at] of [25, 1000, 262144 + 50].entries()) {
    assert.ok(Math.abs(samples[i][0] - Math.sin((6.2831 * 440 * at) / 44100)) < 2e-2, `left, ${at}`);
    assert.ok(Math.abs(samples[i][1] - (at % 100) / 100) < 1e-3, `right, ${at}`);
  }
  await page.click('#play');
  assert.ok(await page.evaluate(() => globalThis.shaderport.player.sound.source === null), 'sound stops with the clock');
}

const READER = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U / iResolution.xy) + vec4(iChannelResolution[0].xy, 0.0, 0.0) / 2550.0; }';

async function drop(context) {
  const { page } = await show(context, 'drop', READER, '#size=32x32&paused', '--no-stand-ins');
  assert.deepEqual((await pixels(page)).slice(0, 3), [0, 0, 0], 'an empty channel is black');
  const base64 = await picture(page);
  await page.evaluate((data) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const files = new DataTransfer();
    files.items.add(new File([bytes], 'four.png', { type: 'image/png' }));
    const event = new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true });
    document.querySelector('#stage').dispatchEvent(event);
  }, base64);
  await page.waitForFunction(() => globalThis.shaderport.player.inputs[0][0].isLoaded);
  const drawn = await pixels(page);
  const at = (x, y) => drawn.slice(4 * (32 * y + x), 4 * (32 * y + x) + 3).map((v) => (v > 128 ? 1 : 0));
  assert.deepEqual([at(4, 28), at(28, 28), at(4, 4), at(28, 4)], [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]);
}

async function embedded(context) {
  const blank = await context.newPage();
  const file = put('four.png', Buffer.from(await picture(blank), 'base64'));
  const { page } = await show(context, 'embedded', READER, '#size=32x32&paused', '--channel', `0=${file},nearest,clamp`);
  const drawn = await frame(page, 0);
  assert.deepEqual(drawn.slice(0, 2).map((v) => (v > 128 ? 1 : 0)), [0, 0]);
  assert.equal(drawn[2], 255, 'the lower left corner is from the image');
  assert.equal(colors(drawn), 4);
}

async function devices(context) {
  const toy = shader({
    type: 'image', name: '', outputs: [],
    inputs: [{ id: '1', type: 'mic', channel: 0, sampler: {} }, { id: '2', type: 'webcam', channel: 1, sampler: {} }, { id: '3', type: 'music', channel: 2, sampler: {} }],
    code: 'void mainImage(out vec4 O, vec2 U) { vec2 p = U / iResolution.xy; O = vec4(texture(iChannel0, vec2(p.x, 0.25)).x, texture(iChannel2, vec2(p.x, 0.75)).x, texture(iChannel1, p).x, 1.0); }',
  });
  const { page } = await show(context, 'devices', toy, '#size=64x36&paused');
  const silent = await frame(page, 5);
  assert.ok(colors(silent) > 30, 'a synthetic signal replaces the microphone');
  assert.ok(silent.every((v, i) => i % 4 !== 2 || v === 0), 'without a camera the channel is black');
  assert.match(await page.textContent('#notices'), /iChannel1 uses the camera/);
  await page.click('#notices button:has-text("Allow")');
  await page.waitForFunction(() => document.querySelector('#notices').textContent === '');
  const seen = await frame(page, 5);
  assert.ok(seen.some((v, i) => i % 4 === 2 && v > 0), 'the camera image');
}

async function whole(context) {
  const code = `#version 300 es
precision highp float;
uniform vec2 u_resolution;
uniform float u_time;
uniform int iFrame;
in vec2 vUv;
out vec4 color;
void main() { color = vec4(gl_FragCoord.xy / u_resolution, fract(vUv.x + u_time + float(iFrame)), 1.0); }
`;
  const { page } = await show(context, 'whole', code, '#size=64x36&paused');
  const first = await frame(page, 0);
  assert.ok(colors(first) > 1000);
  assert.ok(differences(first, await frame(page, 20)) > 1000);
}

async function repaired(context) {
  for (const name of ['old.glsl', 'webgl1.frag']) {
    const file = path.join(top, 'tests/fixtures', name);
    const { page } = await open(context, await port(file, name, '--repair'), '#size=32x18&paused');
    await page.evaluate(() => globalThis.shaderport.ready);
    assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), []);
    const first = await frame(page, 0);
    assert.ok(colors(first) > 10, 'the page draws');
    assert.ok(differences(first, await frame(page, 10)) > 0, 'global values follow the time');
  }
}

async function strict(context) {
  const reader = (channel, wrap) => ({ id: '4dXGR8', type: 'buffer', channel, sampler: { filter: 'nearest', wrap } });
  const toy = shader(
    { type: 'image', name: '', outputs: [], inputs: [reader(0, 'repeat'), reader(1, 'clamp')],
      code: 'void mainImage(out vec4 O, vec2 U) { vec2 p = 3.0 * U / iResolution.xy; O = vec4(texture(iChannel0, p).x, texture(iChannel1, p).x, 0.0, 1.0); }' },
    { type: 'buffer', name: '', inputs: [], outputs: [{ id: '4dXGR8' }], code: 'void mainImage(out vec4 O, vec2 U) { O = vec4(U.x / iResolution.x); }' },
  );
  const ours = await show(context, 'own_samplers', toy, '#size=32x18&paused');
  const theirs = await show(context, 'strict', toy, '#size=32x18&paused', '--strict-player');
  const differ = (bytes) => bytes.filter((v, i) => i % 4 === 0 && v !== bytes[i + 1]).length;
  assert.ok(differ(await frame(ours.page, 0)) > 100, 'each channel has its own wrap mode');
  assert.equal(differ(await frame(theirs.page, 0)), 0, 'the last wrap mode applies to both');
}

async function look(context) {
  const { page } = await show(context, 'look', MOVING, '#paused');
  await page.click('#more');
  const width = page.viewportSize().width;
  const parts = await page.$$eval('#bar > *, #panel', (all) => all.filter((e) => e.checkVisibility()).map((e) => [e.id, e.getBoundingClientRect().left, e.getBoundingClientRect().right]));
  for (const [id, left, right] of parts) assert.ok(left >= 0 && right <= width, `${id} is outside the page`);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
  const small = await page.$$eval('#bar button', (all) => all.filter((e) => e.checkVisibility() && e.getBoundingClientRect().height < 32).length);
  assert.equal(small, 0, 'buttons are large enough for touch');
  const unnamed = await page.$$eval('button, input, select', (all) => all.filter((e) => !e.title && !e.textContent && !e.getAttribute('aria-label') && !e.closest('label')).length);
  assert.equal(unnamed, 0, 'every control has a name');
  return page;
}

async function colorsOfTheme(context) {
  const page = await look(context);
  const dark = await page.evaluate(() => matchMedia('(prefers-color-scheme: dark)').matches);
  const back = await page.evaluate(() => getComputedStyle(document.querySelector('#bar')).backgroundColor);
  const [red] = back.match(/\d+/g).map(Number);
  assert.equal(red < 128, dark, `the bar is ${back}`);
}

async function lostContext(context) {
  const { page } = await show(context, 'lost', MOVING, '#size=32x18&paused');
  await page.evaluate(async () => {
    const { player } = globalThis.shaderport;
    const lose = player.gl.getExtension('WEBGL_lose_context');
    const comes = (name) => new Promise((resolve) => { player.canvas.addEventListener(name, resolve, { once: true }); });
    const [lost, restored] = [comes('webglcontextlost'), comes('webglcontextrestored')];
    lose.loseContext();
    await lost;
    // Restoring is allowed only after the listeners have returned.
    await new Promise((resolve) => { requestAnimationFrame(resolve); });
    lose.restoreContext();
    await restored;
    await player.ready;
  });
  assert.ok(colors(await frame(page, 3)) > 10, 'the page draws again');
  assert.equal(await page.textContent('#notices'), '');
  await page.evaluate(() => globalThis.shaderport.player.gl.getExtension('WEBGL_lose_context').loseContext());
  await page.waitForFunction(() => document.querySelector('#notices').textContent.includes('WebGL context lost'));
}

const small = { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

export const pageTests = [
  { name: 'page: the buttons play, pause and restart', run: playAndPause, context: desk },
  { name: 'page: scrubbing sets the time', run: scrub },
  { name: 'page: the address sets size, time and pause', run: address },
  { name: 'page: the mouse sets iMouse', run: mouse },
  { name: 'page: touch sets iMouse', run: touch, context: small },
  { name: 'page: keys count only while the canvas has the focus', run: keyboard },
  { name: 'page: buffers keep their content when size or scale change', run: resize, context: desk },
  { name: 'page: the sound pass plays', run: sound },
  { name: 'page: an image dropped on a channel is read', run: drop },
  { name: 'page: an embedded image is read', run: embedded },
  { name: 'page: a missing microphone, camera or music is replaced', run: devices },
  { name: 'page: a complete WebGL2 shader is drawn', run: whole },
  { name: 'page: repaired old code is drawn', run: repaired },
  { name: 'page: --strict-player shares samplers', run: strict },
  { name: 'page: a lost graphics context is restored', run: lostContext },
  { name: 'page: the bar follows the dark theme', run: colorsOfTheme, context: { colorScheme: 'dark' } },
  { name: 'page: the bar follows the light theme', run: colorsOfTheme, context: { colorScheme: 'light' } },
  { name: 'page: the controls fit a phone', run: look, context: small },
  ...layoutTests,
  ...inputTests,
  ...mediaTests,
  ...controlTests,
  ...codeTests,
  ...exportTests,
  ...embedTests,
];

// Sliders and other controls, and the address that stores their values.
import assert from 'node:assert/strict';
import { becomes, pixels, port, put } from '../browser.js';
import { desk, MOVING, noticed, openTab, show } from './show.js';

const define = (page, name) => page.evaluate((n) => new RegExp(`#define ${n} (\\S+)`).exec(globalThis.shaderport.player.project.files.find((f) => !f.hidden).text)[1], name);
const hash = (page) => page.evaluate(() => location.hash);

async function sliders(context) {
  const { page } = await show(context, 'sliders', MOVING, '#size=64x36&t=0.3&paused');
  await openTab(page, 'Controls');
  assert.deepEqual(await page.$$eval('#sliders [type=range]', (all) => all.map((i) => [i.name, i.min, i.max, i.value])), [
    ['SPEED', '0.3', '4', '1'],
    ['STRIPES', '1', '9', '4'],
  ]);
  const before = await pixels(page);
  await page.fill('input[name=STRIPES]', '9');
  await page.waitForFunction(() => globalThis.shaderport.player.project.files.some((f) => /STRIPES 9 /.test(f.text)));
  // The image follows the slider.
  await becomes(page, before, false);
  await page.fill('[aria-label="SPEED, number"]', '2.5');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /SPEED 2\.5/.test(globalThis.shaderport.player.project.files.find((f) => !f.hidden).text));
  assert.equal(await page.inputValue('input[name=SPEED]'), '2.5');
  await page.waitForFunction(() => location.hash.includes('u.SPEED=2.5') && location.hash.includes('u.STRIPES=9'));
  assert.match(await hash(page), /^#size=64x36&t=0\.3&paused&/, 'the rest of the address is unchanged');
  await page.dblclick('input[name=SPEED]');
  await page.waitForFunction(() => !location.hash.includes('u.SPEED'));
  assert.equal(await define(page, 'SPEED'), '1.0');
  await page.click('[aria-label="Reset STRIPES"]');
  await page.waitForFunction(() => !location.hash.includes('u.STRIPES'));
  // Everything is back to its default.
  await becomes(page, before);
}

const CONSTANTS = `const float SPEED = 0.25; // (0~1)
const int N = 2; // (1~4)
const int TWICE = 2 * N;
const vec3 SKY = vec3(.2, .4, .6); // Sky (color)
const vec2 SHIFT = vec2(0); //! slider[(-1,-1), (0,0), (1,1)]
const bool ON = true;
#define GAIN 1.0 // in {0.0, 2.0}
`;

/** Constants have sliders; what is computed from them follows, and the page draws the same until one is moved. */
async function constants(context) {
  const image = `void mainImage(out vec4 O, vec2 U) {
    float all[TWICE];
    for (int i = 0; i < TWICE; i++) all[i] = float(i) * SPEED;
    O = vec4(GAIN * SKY + SHIFT.xyx + vec3(ON ? 0.0 : 0.4), 1.0) + all[TWICE - 1] * 0.1 + iTime * 0.0;
  }`;
  const shader = { renderpass: [['common', CONSTANTS], ['image', image]].map(([type, code]) => ({ type, code, inputs: [], outputs: [] })) };
  const hash = '#size=8x8&t=0.3&paused';
  const plain = await show(context, 'plain-constants', shader, hash, '--sliders', 'none');
  assert.equal(await plain.page.evaluate(() => globalThis.shaderport.player.project.tunables.length), 0);
  const before = await pixels(plain.page);
  const { page } = await show(context, 'constants', shader, hash);
  assert.deepEqual(await pixels(page), before);
  await openTab(page, 'Controls');
  assert.deepEqual(await page.$$eval('#sliders input:not([type=number])', (all) => all.map((i) => `${i.name} ${i.type}`)), [
    'GAIN range', 'SPEED range', 'N range', 'SKY color', 'SHIFT.x range', 'SHIFT.y range', 'ON checkbox',
  ]);
  const drawn = (sky, add) => [...sky.map((c) => Math.min(Math.round(255 * (c + add)), 255)), 255];
  const shows = (expected) => page.waitForFunction((wanted) => {
    const { gl } = globalThis.shaderport.player;
    const bytes = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return wanted.every((v, i) => Math.abs(v - bytes[i]) <= 1);
  }, expected);
  await shows(drawn([0.2, 0.4, 0.6], 0.075));
  await page.fill('input[name=N]', '4');
  await shows(drawn([0.2, 0.4, 0.6], 0.175));
  await page.fill('input[name=SKY]', '#0080ff');
  await page.fill('input[name="SHIFT.y"]', '0.25');
  await shows(drawn([0, 0.752, 1], 0.175));
  await page.uncheck('input[name=ON]');
  await shows([147, 255, 255, 255]);
  await page.waitForFunction(() => ['u.N=4', 'u.SKY=0,0.502,1', 'u.SHIFT=0,0.25', 'u.ON=0'].every((w) => location.hash.includes(w)));
  await page.click('#sliders > button:text-is("Reset all")');
  await becomes(page, before);
}

/** Labels of ISF are the names of its controls; the uniforms keep theirs. */
async function labels(context) {
  const code = `/*{ "ISFVSN": "2", "INPUTS": [
    { "NAME": "amount", "LABEL": "Strength", "TYPE": "float", "DEFAULT": 0.5 },
    { "NAME": "mode", "LABEL": "Mode of it", "TYPE": "long", "LABELS": [ "Soft", "Hard" ], "VALUES": [ 2, 5 ], "DEFAULT": 5 },
    { "NAME": "plain", "TYPE": "bool" }
  ] }*/
  void main() { gl_FragColor = vec4(amount, float(mode) / 5.0, plain ? 1.0 : 0.0, 1.0); }`;
  const { page } = await show(context, 'labels', code, '#size=8x8&paused&u.amount=0.25');
  await openTab(page, 'Controls');
  assert.deepEqual(await page.$$eval('#sliders .head > :first-child', (all) => all.map((n) => [n.textContent, n.title])), [
    ['Strength', 'amount'], ['Mode of it', 'mode'], ['plain', 'plain'],
  ]);
  assert.equal(await page.inputValue('input[name=amount]'), '0.25');
  assert.equal(await page.getAttribute('input[name=amount]', 'aria-label'), 'Strength');
  assert.deepEqual(await page.$$eval('select[name=mode] option', (all) => all.map((o) => [o.textContent, o.value])), [['Soft', '2'], ['Hard', '5']]);
  await page.selectOption('select[name=mode]', '2');
  await page.waitForFunction(() => location.hash.includes('u.mode=2'));
}

async function restored(context) {
  const { page } = await show(context, 'restored', MOVING, '#size=64x36&t=1e308&paused&u.SPEED=3&u.STRIPES=1000&u.NONE=1');
  await page.waitForFunction(() => /SPEED 3\.0[\s\S]*STRIPES 9 /.test(globalThis.shaderport.player.project.files.find((f) => !f.hidden).text));
  assert.equal(await page.evaluate(() => globalThis.shaderport.player.clock.time), 3e7);
  await openTab(page, 'Controls');
  assert.equal(await page.inputValue('input[name=SPEED]'), '3');
  await page.evaluate(() => { location.hash = '#size=64x36&t=4&paused&u.SPEED=2'; });
  await page.waitForFunction(() => globalThis.shaderport.player.clock.time === 4);
  await page.waitForFunction(() => /SPEED 2\.0/.test(globalThis.shaderport.player.project.files.find((f) => !f.hidden).text));
}

/** Without the permission it copies a selection, whose style the policy of the page blocks. */
async function copied(context) {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const { page } = await show(context, 'copied', MOVING, '#size=64x36&paused&u.SPEED=3');
  await openTab(page, 'Export');
  await page.evaluate(() => globalThis.shaderport.seek(12.5));
  const copy = async (what) => {
    await page.click(`#export button:text-is("${what}")`);
    await noticed(page, `${what} copied`);
    return page.evaluate(() => navigator.clipboard.readText());
  };
  const link = await copy('Link');
  assert.match(link, /^file:.*copied\.html#size=64x36&paused&u\.SPEED=3&t=12\.50$/);
  const glsl = await copy('GLSL');
  assert.match(glsl, /^#version 300 es/);
  assert.match(glsl, /#define SPEED 3\.0/);
  const frame = await copy('Embed code');
  assert.match(frame, /^<iframe src="file:[^"]*copied\.html#[^"]*&amp;embed" title="copied" width="64" height="36" loading="lazy" /);
  const again = await context.newPage();
  await again.goto(link);
  await again.evaluate(() => globalThis.shaderport.ready);
  assert.equal(await again.evaluate(() => globalThis.shaderport.player.clock.time), 12.5);
  // The link shows the same.
  await becomes(again, await pixels(page));
  const module = await copy('Module');
  const blank = await context.newPage();
  const plays = await blank.evaluate(async (text) => {
    const { mount } = await import(`data:text/javascript;base64,${btoa(Array.from(new TextEncoder().encode(text), (c) => String.fromCharCode(c)).join(''))}`);
    const shader = mount(document.createElement('canvas'), { size: [64, 36], paused: true });
    await shader.ready;
    return shader.errors;
  }, module);
  assert.deepEqual(plays, []);
  assert.match(module, /#define SPEED 3\.0/);
}

async function scale(context) {
  const { page } = await show(context, 'scale', MOVING, '#paused');
  await page.selectOption('#scale', '0.5');
  assert.equal(await page.evaluate(() => globalThis.shaderport.player.canvas.width), 500);
  await page.waitForFunction(() => location.hash.includes('scale=0.5'));
  await page.reload();
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.equal(await page.evaluate(() => globalThis.shaderport.player.canvas.width), 500);
  assert.equal(await page.inputValue('#scale'), '0.5');
}

/** A page with controls of every kind, and a player that stores their values. */
async function kinds(context) {
  const address = await port(put('kinds.glsl', MOVING), 'kinds');
  const page = await context.newPage();
  const errors = [];
  page.on('pageerror', (e) => errors.push(e.message));
  await page.addInitScript((controls) => {
    const parse = JSON.parse;
    JSON.parse = (text) => {
      const value = parse(text);
      return value?.passes ? { ...value, controls } : value;
    };
  }, [
    { name: 'gain', label: 'Gain', kind: 'float', value: [0.5], min: [0], max: [2] },
    { name: 'count', label: '', kind: 'int', value: [3], min: [1], max: [8] },
    { name: 'invert', label: '', kind: 'bool', value: [0] },
    { name: 'tint', label: '', kind: 'color', value: [1, 0.5, 0, 1] },
    { name: 'spot', label: '', kind: 'point', value: [0.5, 0.5], min: [0, 0], max: [1, 1] },
    { name: 'axis', label: '', kind: 'vector', value: [0, 1, 0], min: [-1, -1, -1], max: [1, 1, 1] },
    { name: 'mode', label: '', kind: 'choice', value: [0], choices: [{ label: 'soft', value: 0 }, { label: 'hard', value: 2 }] },
    { name: 'flash', label: '', kind: 'event', value: [0] },
  ]);
  await page.goto(`${address}#size=64x36&paused&u.gain=1.5`);
  await page.evaluate(() => globalThis.shaderport.ready);
  const value = (name) => page.evaluate((n) => globalThis.shaderport.player.project.controls.find((c) => c.name === n).value, name);
  assert.deepEqual(await value('gain'), [1.5]);
  await openTab(page, 'Controls');
  await page.check('input[name=invert]');
  assert.deepEqual(await value('invert'), [1]);
  await page.fill('input[name=tint]', '#00ff80');
  assert.deepEqual(await value('tint'), [0, 1, 0.502, 1]);
  await page.fill('input[name="axis.x"]', '-0.5');
  assert.deepEqual(await value('axis'), [-0.5, 1, 0]);
  await page.selectOption('select[name=mode]', '2');
  assert.deepEqual(await value('mode'), [2]);
  await page.locator('.pad').scrollIntoViewIfNeeded();
  const pad = await page.locator('.pad').boundingBox();
  await page.mouse.click(pad.x + pad.width * 0.25, pad.y + pad.height * 0.25);
  const [x, y] = await value('spot');
  assert.ok(Math.abs(x - 0.25) < 0.02 && Math.abs(y - 0.75) < 0.02);
  await page.click('button[title=flash]');
  await page.waitForFunction(() => globalThis.shaderport.player.project.controls.find((c) => c.name === 'flash').value[0] === 0);
  await page.waitForFunction(() => ['u.invert=1', 'u.tint=0,1,0.502,1', 'u.axis=-0.5,1,0', 'u.mode=2'].every((w) => location.hash.includes(w)));
  await page.click('#sliders > button:text-is("Reset all")');
  assert.deepEqual(await value('tint'), [1, 0.5, 0, 1]);
  assert.ok(!(await page.isChecked('input[name=invert]')));
  assert.deepEqual(errors, []);
}

/** Slow frames, measured by the page's own clock, are reported, and a smaller scale is offered. */
async function heavy(context) {
  await context.clock.install();
  // It plays once its clock stands still.
  const { page } = await show(context, 'heavy', MOVING, '#paused');
  await page.clock.pauseAt(Date.now() + 3600e3);
  await page.click('#play');
  for (const each of [1 / 60, 0.3]) {
    for (let i = 0; i < 10; i++) await page.clock.fastForward(1000 * each);
    const words = await page.textContent('#notices');
    assert.equal(words.includes('slow'), each > 0.25, `frames of ${each} s: ${words}`);
  }
  assert.match(await page.textContent('#notices'), /This shader is slow on this device: 3\.3 fps/);
  await page.click('.notice button:text-is("Render at ½×")');
  assert.equal(await page.inputValue('#scale'), '0.5');
  assert.equal(await page.textContent('#notices'), '');
}

export const controlTests = [
  { name: 'page: sliders change tunable numbers', run: sliders, context: desk },
  { name: 'page: sliders change constants', run: constants, context: desk },
  { name: 'page: controls have the labels of ISF', run: labels, context: desk },
  { name: 'page: options in the address are restored', run: restored, context: desk },
  { name: 'page: the link, the shader and the module are copied', run: copied, context: desk, mayComplain: true },
  { name: 'page: the scale stays in the address', run: scale, context: desk },
  { name: 'page: controls of every kind set their uniforms', run: kinds, context: desk },
  { name: 'page: slow frames are reported', run: heavy, context: desk },
];

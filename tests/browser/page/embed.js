// Pages for frames of other pages, which show a still image until they are clicked, and galleries.
import assert from 'node:assert/strict';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { colors, folder, frames, open, pixels, port, put, shaderport } from '../browser.js';
import { desk, MOVING, phone } from './show.js';

/** Opens an embedded page; `contexts` counts the contexts that its canvas gave. */
async function show(context, name, hash = '', code = MOVING) {
  await context.addInitScript(() => {
    globalThis.contexts = 0;
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function count(...args) {
      globalThis.contexts++;
      return getContext.apply(this, args);
    };
  });
  const opened = await open(context, await port(put(`${name}.glsl`, code), name, '--embed'), hash);
  return opened;
}

/** Waits until a page or frame plays without its poster. */
const plays = (page) => page.waitForFunction(() => globalThis.shaderport?.player.isPlaying && !document.querySelector('#poster'));

const contexts = (page) => page.evaluate(() => globalThis.contexts);

async function click(context) {
  const { page, complaints } = await show(context, 'click');
  await frames(page);
  assert.equal(await contexts(page), 0, 'nothing is drawn before the click');
  assert.equal(await page.evaluate(() => globalThis.shaderport), undefined, 'nothing is compiled before the click');
  assert.deepEqual(await page.$eval('#poster img', (image) => [image.naturalWidth, image.naturalHeight]), [640, 360]);
  const { width, height } = page.viewportSize();
  assert.deepEqual(await page.locator('#poster img').boundingBox(), { x: 0, y: 0, width, height });
  const visible = await page.$$eval('#bar, #panel, canvas, #notices *', (all) => all.filter((e) => e.checkVisibility()).map((e) => e.id));
  assert.deepEqual(visible, [], 'only the image and the button');
  await page.getByRole('button', { name: 'Play click', exact: true }).click();
  await plays(page);
  assert.ok(await contexts(page) > 0);
  assert.ok(colors(await pixels(page)) > 10);
  assert.ok(!(await page.isVisible('#begin')));
  const box = await page.locator('canvas').boundingBox();
  assert.deepEqual([box.width, box.height], [width, height], 'the bar covers the canvas and takes no room');
  // An idle bar lets clicks through. The first movement shows it, the second one is on it.
  await page.mouse.move(width / 2, height - 10);
  await page.mouse.move(width / 2 + 5, height - 10);
  await page.click('#more');
  assert.ok(await page.isVisible('#panel'));
  assert.deepEqual(complaints, []);
}

async function image(context) {
  const { page, complaints } = await show(context, 'image');
  await page.mouse.click(20, 20);
  await plays(page);
  assert.deepEqual(complaints, []);
}

async function keyboard(context) {
  const { page, complaints } = await show(context, 'keys');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'begin', 'the first stop is the button');
  assert.notEqual(await page.$eval('#begin', (e) => getComputedStyle(e).outlineStyle), 'none', 'focus is visible');
  await page.keyboard.press('Enter');
  await plays(page);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'canvas');
  await page.keyboard.press('Space');
  assert.ok(await page.evaluate(() => !globalThis.shaderport.player.isPlaying));
  assert.deepEqual(complaints, []);
}

/** A link of a gallery starts the shader, unless its user asks for less motion; a click always does. */
async function calm(context) {
  const { page, complaints } = await show(context, 'calm', '#play');
  await frames(page);
  assert.equal(await contexts(page), 0);
  await page.click('#begin');
  await plays(page);
  assert.deepEqual(complaints, []);
}

async function linked(context) {
  const { page, complaints } = await show(context, 'linked', '#play&paused');
  await plays(page);
  assert.deepEqual(complaints, []);
}

/** As the documentation recommends: a frame that may only run scripts. */
async function framed(context) {
  const address = await port(put('inner.glsl', MOVING), 'inner', '--embed');
  const frame = `<iframe src="${address}" title="Water" loading="lazy" sandbox="allow-scripts" allow="autoplay; fullscreen" style="width: 400px; height: 225px"></iframe>`;
  const { page, complaints } = await open(context, pathToFileURL(put('outer.html', `<!doctype html><title>x</title>${frame}`)).href);
  await page.frameLocator('iframe').locator('#begin').click();
  const inner = page.frames().find((f) => f.url().endsWith('inner.html'));
  await plays(inner);
  assert.ok(colors(await pixels(inner)) > 10);
  assert.deepEqual(complaints, []);
}

async function plain(context) {
  const vertices = 'attribute float vertexId;\nvarying vec4 v_color;\nvoid main() {\n  gl_Position = vec4(fract(vertexId * 0.37) - 0.5, fract(vertexId * 0.71) - 0.5, 0.0, 1.0);\n  gl_PointSize = 4.0;\n  v_color = vec4(1.0);\n}\n';
  const { page, complaints } = await show(context, 'plain', '', vertices);
  assert.equal(await page.locator('#poster img').count(), 0);
  assert.match(await page.$eval('#poster', (e) => getComputedStyle(e).backgroundImage), /gradient/);
  await page.click('#begin');
  await plays(page);
  assert.deepEqual(complaints, []);
}

/** Opens a gallery of two shaders. */
async function gallery(context) {
  put('many/stripes.glsl', MOVING);
  put('many/a long title with words.glsl', MOVING);
  const out = path.join(folder(), 'out');
  const { code, stderr } = await shaderport('gallery', path.join(folder(), 'many'), '-o', out);
  assert.equal(code, 0, stderr);
  return open(context, pathToFileURL(path.join(out, 'index.html')).href);
}

async function cards(context) {
  const { page, complaints } = await gallery(context);
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  assert.deepEqual(await page.$$eval('img', (all) => all.map((image) => image.naturalWidth)), [640, 640]);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), page.viewportSize().width);
  const dark = await page.evaluate(() => matchMedia('(prefers-color-scheme: dark)').matches);
  const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(Number(back.match(/\d+/)[0]) < 128, dark, `the page is ${back}`);
  assert.equal(await page.locator('canvas, script, button').count(), 0, 'nothing plays here');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), 'stripes');
  assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle), 'none', 'focus is visible');
  await page.keyboard.press('Enter');
  await page.waitForURL(/stripes\.html#play$/);
  await plays(page);
  assert.ok(colors(await pixels(page)) > 10);
  assert.deepEqual(complaints, []);
}

export const embedTests = [
  { name: 'embed: nothing runs before the click', run: click, context: desk },
  { name: 'embed: a click on the image', run: image },
  { name: 'embed: the keyboard', run: keyboard },
  { name: 'embed: reduced motion', run: calm, context: { reducedMotion: 'reduce' } },
  { name: 'embed: a link that plays', run: linked },
  { name: 'embed: in a frame that may only run scripts', run: framed },
  { name: 'embed: without a still image', run: plain },
  { name: 'gallery: on a desk', run: cards, context: { ...desk, colorScheme: 'light' } },
  { name: 'gallery: on a phone, dark', run: cards, context: { ...phone, colorScheme: 'dark' } },
];

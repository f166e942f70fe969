// Pages for frames of other pages, which show a still image until they play, and galleries.
import assert from 'node:assert/strict';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { colors, folder, frames, open, pixels, port, put, shaderport } from '../browser.js';
import { desk, MOVING, phone } from './show.js';

/** Opens an embedded page that waits for a click; `contexts` counts the contexts that its canvas gave. */
async function show(context, name, hash = '', code = MOVING, ...more) {
  await context.addInitScript(() => {
    globalThis.contexts = 0;
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function count(...args) {
      globalThis.contexts++;
      return getContext.apply(this, args);
    };
  });
  const opened = await open(context, await port(put(`${name}.glsl`, code), name, '--embed', '--click', ...more), hash);
  return opened;
}

/** Waits until a page or frame plays without its poster. */
const plays = (page) => page.waitForFunction(() => globalThis.shaderport?.player.isPlaying && !document.querySelector('#poster'));

const contexts = (page) => page.evaluate(() => globalThis.contexts);

async function click(context) {
  const { page } = await show(context, 'click');
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
  assert.deepEqual(await page.$$eval('#bar > *', (all) => all.filter((e) => e.checkVisibility()).map((e) => e.id)), ['play', 'restart', 'scrub', 'time', 'full']);
  await page.click('#play');
  assert.ok(await page.evaluate(() => !globalThis.shaderport.player.isPlaying));
}

async function image(context) {
  const { page } = await show(context, 'image');
  await page.mouse.click(20, 20);
  await plays(page);
}

async function keyboard(context) {
  const { page } = await show(context, 'keys');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'begin', 'the first stop is the button');
  assert.notEqual(await page.$eval('#begin', (e) => getComputedStyle(e).outlineStyle), 'none', 'focus is visible');
  await page.keyboard.press('Enter');
  await plays(page);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'canvas');
  await page.keyboard.press('Space');
  assert.ok(await page.evaluate(() => !globalThis.shaderport.player.isPlaying));
}

/** A link of a gallery starts the shader, unless its user asks for less motion; a click always does. */
async function calm(context) {
  const { page } = await show(context, 'calm', '#play');
  await frames(page);
  assert.equal(await contexts(page), 0);
  await page.click('#begin');
  await plays(page);
}

async function linked(context) {
  const { page } = await show(context, 'linked', '#play&paused');
  await plays(page);
}

/** As the documentation recommends: a frame that may only run scripts. */
async function framed(context) {
  const address = await port(put('inner.glsl', MOVING), 'inner', '--embed', '--click');
  const frame = `<iframe src="${address}" title="Water" loading="lazy" sandbox="allow-scripts" allow="autoplay; fullscreen" style="width: 400px; height: 225px"></iframe>`;
  const { page } = await open(context, pathToFileURL(put('outer.html', `<!doctype html><title>x</title>${frame}`)).href);
  await page.frameLocator('iframe').locator('#begin').click();
  const inner = page.frames().find((f) => f.url().endsWith('inner.html'));
  await plays(inner);
  assert.ok(colors(await pixels(inner)) > 10);
}

async function plain(context) {
  const vertices = 'attribute float vertexId;\nvarying vec4 v_color;\nvoid main() {\n  gl_Position = vec4(fract(vertexId * 0.37) - 0.5, fract(vertexId * 0.71) - 0.5, 0.0, 1.0);\n  gl_PointSize = 4.0;\n  v_color = vec4(1.0);\n}\n';
  const { page } = await show(context, 'plain', '', vertices);
  assert.equal(await page.locator('#poster img').count(), 0);
  assert.match(await page.$eval('#poster', (e) => getComputedStyle(e).backgroundImage), /gradient/);
  await page.click('#begin');
  await plays(page);
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
  const { page } = await gallery(context);
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  assert.deepEqual(await page.$$eval('img', (all) => all.map((image) => image.naturalWidth)), [640, 640]);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), page.viewportSize().width);
  const dark = await page.evaluate(() => matchMedia('(prefers-color-scheme: dark)').matches);
  const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(Number(back.match(/\d+/)[0]) < 128, dark, `the page is ${back}`);
  assert.equal(await page.locator('canvas, button').count(), 0, 'nothing plays here');
  await page.fill('#search', 'WORDS long');
  assert.deepEqual(await page.$$eval('li', (all) => all.filter((e) => e.checkVisibility()).map((e) => e.querySelector('b').textContent)), ['a long title with words']);
  await page.fill('#search', 'nothing like this');
  assert.ok(await page.isVisible('#none'));
  await page.fill('#search', '');
  await page.focus('#search');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), 'stripes');
  assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle), 'none', 'focus is visible');
  await page.keyboard.press('Enter');
  await page.waitForURL(/stripes\.html#play$/);
  await plays(page);
  assert.ok(colors(await pixels(page)) > 10);
}

/** Without `--click` it plays as soon as it is seen, and shows its still image until then. */
async function seen(context) {
  const address = await port(put('seen.glsl', MOVING), 'seen', '--embed');
  const frame = `<div style="height: 3000px"></div><iframe src="${address}" style="width: 400px; height: 225px"></iframe>`;
  const { page } = await open(context, pathToFileURL(put('tall.html', `<!doctype html><title>x</title>${frame}`)).href);
  const inner = page.frames().find((f) => f.url().endsWith('seen.html'));
  await inner.waitForFunction(() => globalThis.shaderport);
  await frames(page);
  assert.ok(await inner.evaluate(() => globalThis.shaderport.player.renderer === null && document.querySelector('#poster') !== null));
  await page.locator('iframe').scrollIntoViewIfNeeded();
  await plays(inner);
  const time = () => inner.evaluate(() => globalThis.shaderport.player.clock.time);
  await page.evaluate(() => scrollTo(0, 0));
  await inner.waitForFunction(() => !globalThis.shaderport.player.isSeen, null, { polling: 100 });
  const before = await time();
  await frames(page, 20);
  assert.equal(await time(), before, 'it stands still');
  await inner.evaluate(() => {
    const { player } = globalThis.shaderport;
    const paint = player.paint.bind(player);
    player.paint = (tick) => {
      globalThis.firstTime ??= tick.time;
      paint(tick);
    };
  });
  await page.locator('iframe').scrollIntoViewIfNeeded();
  await inner.waitForFunction((t) => globalThis.shaderport.player.clock.time > t, before);
  assert.equal(await inner.evaluate(() => globalThis.firstTime), before, 'the time goes on where it stood');
}

/** A simulation goes on where it stood, although its context was given back. */
async function simulation(context) {
  const counter = 'void mainImage(out vec4 O, vec2 U) { O = texelFetch(iChannel0, ivec2(U), 0) + 1.0; }\n';
  const image = 'void mainImage(out vec4 O, vec2 U) { O = vec4(fract(texelFetch(iChannel0, ivec2(0), 0).r / 100.0)); }\n';
  put('count/buffer_a.glsl', counter);
  put('count/image.glsl', image);
  const address = await port(path.join(folder(), 'count'), 'count', '--channel', 'buffer_a.0=buffer_a', '--channel', 'image.0=buffer_a');
  const { page } = await open(context, address, '#paused&size=8x8');
  const steps = await page.evaluate(async () => {
    const { player, renderFrame } = globalThis.shaderport;
    const value = () => {
      const texel = new Float32Array(4);
      const { gl } = player;
      const buffer = [...player.renderer.buffers.values()][0];
      gl.bindFramebuffer(gl.FRAMEBUFFER, buffer.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, buffer.texture, 0);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, texel);
      return [texel[0], gl.getError()];
    };
    await renderFrame(9);
    const first = value();
    const until = async (holds) => {
      while (!holds()) await new Promise((resolve) => { requestAnimationFrame(resolve); });
    };
    player.rest();
    await until(() => player.canvas.style.background.startsWith('url("data:image'));
    const isResting = player.renderer === null;
    const { number } = player.clock;
    player.open();
    // It draws a frame when all is back.
    await until(() => player.clock.number > number);
    player.step();
    return [first, isResting, value(), player.canvas.style.background];
  });
  // Opening it again draws a frame.
  assert.deepEqual(steps, [[10, 0], true, [12, 0], '']);
}

/** Forty frames, scrolled through: never more contexts than browsers keep, and no image is black. */
async function forty(context) {
  const address = await port(put('many.glsl', MOVING.replace('0.2', '0.6')), 'many', '--embed');
  const all = `<iframe src="${address}" loading="lazy" style="width: 80px; height: 45px; border: 0"></iframe>\n`.repeat(40);
  const { page } = await open(context, pathToFileURL(put('forty.html', `<!doctype html><title>x</title><body style="margin: 0; background: #fff">${all}`)).href);
  const count = async () => {
    const open = await Promise.all(page.frames().slice(1).map((f) => f.evaluate(() => Boolean(globalThis.shaderport?.player.renderer))));
    return open.filter(Boolean).length;
  };
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  const down = Array.from({ length: Math.ceil(height / 100) }, (_, i) => 100 * i);
  for (const top of [...down, ...down.toReversed()]) {
    await page.evaluate((y) => scrollTo(0, y), top);
    const begun = page.frames().slice(1).filter((f) => f.url() !== 'about:blank');
    await Promise.all(begun.map((f) => f.waitForFunction(() => globalThis.shaderport)));
    await frames(page);
    assert.ok(await count() <= 16);
    const dark = await darkShare(page, await page.screenshot());
    assert.ok(dark < 0.02, `${dark} of the window is black at ${top}`);
  }
}

/** A context that is lost before there is a frame leaves the still image, and then comes back. */
async function lostEarly(context) {
  await context.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    let isFirst = true;
    HTMLCanvasElement.prototype.getContext = function lose(...args) {
      const gl = getContext.apply(this, args);
      if (isFirst && args[0] === 'webgl2') {
        isFirst = false;
        globalThis.extension = gl.getExtension('WEBGL_lose_context');
        globalThis.extension.loseContext();
      }
      return gl;
    };
  });
  const address = await port(put('early.glsl', MOVING), 'early', '--embed');
  const { page } = await open(context, address);
  await page.waitForFunction(() => document.querySelector('#canvas').style.objectFit === 'none');
  const shown = await page.$eval('#canvas', (canvas) => [canvas.style.background.startsWith('url("data:image'), canvas.style.objectPosition]);
  assert.deepEqual(shown, [true, '-99999px 0px']);
  await page.evaluate(() => globalThis.extension.restoreContext());
  await plays(page);
  await page.waitForFunction(() => document.querySelector('#canvas').style.objectFit === '');
}

/** The share of pixels of a screenshot that are black. */
function darkShare(page, png) {
  return page.evaluate(async (text) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));
    const to = new OffscreenCanvas(image.width, image.height).getContext('2d');
    to.drawImage(image, 0, 0);
    const { data } = to.getImageData(0, 0, image.width, image.height);
    let dark = 0;
    for (let i = 0; i < data.length; i += 4) dark += data[i] + data[i + 1] + data[i + 2] < 30 ? 1 : 0;
    return (4 * dark) / data.length;
  }, png.toString('base64'));
}

/** Script and style as files, for a site that allows nothing else. */
async function split(context) {
  const { page } = await show(context, 'split', '', MOVING, '--split');
  await page.click('#begin');
  await plays(page);
  assert.deepEqual(await page.$$eval('script:not([type]), style', (all) => all.map((e) => e.textContent)), ['']);
}

export const embedTests = [
  { name: 'embed: nothing runs before the click', run: click, context: desk },
  { name: 'embed: a click on the image plays', run: image },
  { name: 'embed: the keyboard starts and controls the shader', run: keyboard },
  { name: 'embed: reduced motion does not start the shader', run: calm, context: { reducedMotion: 'reduce' } },
  { name: 'embed: a link starts the shader', run: linked },
  { name: 'embed: it runs in a sandbox that allows scripts only', run: framed },
  { name: 'embed: without a still image it shows a gradient', run: plain },
  { name: 'embed: it plays only while it is visible', run: seen, context: desk },
  { name: 'embed: a simulation keeps its state', run: simulation },
  { name: 'embed: the still image stays if the context is lost before a frame', run: lostEarly, context: desk },
  { name: 'embed: forty in one page are never black', only: 'heavy', run: forty, context: { viewport: { width: 440, height: 200 } } },
  { name: 'embed: the script and the style may be files', run: split },
  { name: 'gallery: it fits a desktop and is light', run: cards, context: { ...desk, colorScheme: 'light' } },
  { name: 'gallery: it fits a phone and is dark', run: cards, context: { ...phone, colorScheme: 'dark' } },
];

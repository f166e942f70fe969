// Images, recordings, and the author of the shader.
import assert from 'node:assert/strict';
import zlib from 'node:zlib';
import { shader } from '../cases.js';
import { desk, MOVING, openTab, saved, show, time } from './show.js';

async function shot(context) {
  const { page } = await show(context, 'shot', MOVING, '#t=1.5&paused');
  const [made] = await Promise.all([page.waitForEvent('download'), page.click('#shot')]);
  assert.equal(made.suggestedFilename(), 'shot-1.50s.png');
  const png = await saved(made);
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  assert.ok(png.length > 200);
}

/** The browser's view of a recording: its size, its duration, and how many frames are distinguishable. */
function look(page, film) {
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const video = document.createElement('video');
    video.muted = true;
    video.src = URL.createObjectURL(new Blob([bytes], { type: 'video/webm' }));
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    const to = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const red = async (at) => {
      video.currentTime = at;
      await new Promise((resolve) => { video.onseeked = resolve; });
      to.drawImage(video, 0, 0, 1, 1, 0, 0, 1, 1);
      return to.getImageData(0, 0, 1, 1).data[0];
    };
    const reds = [await red(0.05), await red(0.55), await red(0.95)];
    const audio = new OfflineAudioContext(1, 48000, 48000);
    const sound = await audio.decodeAudioData(bytes.buffer).catch(() => null);
    const lane = sound?.getChannelData(0) ?? [];
    let crossings = 0;
    for (let i = 4800; i < 43200; i++) if (lane[i] < 0 !== lane[i + 1] < 0) crossings++;
    return { width: video.videoWidth, height: video.videoHeight, duration: video.duration, reds, crossings };
  }, film.toString('base64'));
}

async function exactFilm(context) {
  const toy = shader(
    { type: 'image', name: 'Image', inputs: [], outputs: [], code: 'void mainImage(out vec4 O, vec2 U) { O = vec4(clamp(iTime, 0.0, 1.0), 0.0, 0.0, 1.0); }' },
    { type: 'sound', name: '', inputs: [], outputs: [], code: 'vec2 mainSound(in int s, float t) { return vec2(0.5 * sin(6.2831 * 440.0 * t)); }' },
  );
  toy.info.name = 'A film: "x" / é';
  const { page } = await show(context, 'film', toy, '#t=3&paused');
  await openTab(page, 'Export');
  await page.fill('[name=seconds]', '1');
  await page.selectOption('[name=rate]', '30');
  await page.selectOption('[name=size]', '1280x720');
  await page.check('[name="from start"]');
  const before = await page.evaluate(() => document.querySelector('canvas').width);
  const [made] = await Promise.all([page.waitForEvent('download'), page.click('#export button:text-is("Record")')]);
  assert.match(made.suggestedFilename(), /^A-film-x-e.*-3\.00s\.webm$/);
  const seen = await look(page, await saved(made));
  assert.deepEqual([seen.width, seen.height], [1280, 720]);
  assert.ok(Math.abs(seen.duration - 1) < 0.05, `duration ${seen.duration} s`);
  for (const [i, at] of [0.05, 0.55, 0.95].entries()) assert.ok(Math.abs(seen.reds[i] - 255 * at) < 16, `red is ${seen.reds[i]} at ${at} s`);
  // 440 Hz over 0.8 s cross zero 704 times.
  assert.ok(Math.abs(seen.crossings - 704) < 12, `${seen.crossings} zero crossings of the sound`);
  assert.equal(await page.evaluate(() => document.querySelector('canvas').width), before, 'the canvas has its original size');
  assert.equal(await time(page), 3);
}

async function stopped(context) {
  await context.clock.install();
  const { page } = await show(context, 'stopped', MOVING, '#scale=0.25');
  await openTab(page, 'Export');
  // The page's clock is controlled manually, so that the recording does not end.
  await page.clock.pauseAt(Date.now() + 3600e3);
  await page.click('#record');
  assert.equal(await page.getAttribute('#record', 'aria-pressed'), 'true');
  while (await page.evaluate(() => document.querySelector('progress').value < 0.02)) await page.clock.runFor(10);
  const download = page.waitForEvent('download');
  await page.click('#record');
  await page.clock.resume();
  const film = await download;
  assert.match(film.suggestedFilename(), /^stopped-[\d.]+s\.(webm|mp4)$/);
  assert.ok((await saved(film)).length > 1000, 'the recording has frames');
  assert.equal(await page.getAttribute('#record', 'aria-pressed'), 'false');
  // The page keeps playing.
  await page.waitForFunction(() => globalThis.shaderport.player.isPlaying);
}

async function liveFilm(context) {
  await context.clock.install();
  const { page } = await show(context, 'live', MOVING, '#scale=0.25');
  await page.evaluate(() => { delete globalThis.VideoEncoder; });
  await openTab(page, 'Export');
  await page.fill('[name=seconds]', '600');
  const download = page.waitForEvent('download');
  await page.click('#export button:text-is("Record")');
  const number = await page.evaluate(() => globalThis.shaderport.player.clock.number);
  await page.waitForFunction((n) => globalThis.shaderport.player.clock.number > n + 20, number);
  await page.clock.fastForward(600e3);
  const made = await download;
  assert.ok((await saved(made)).length > 1000, 'without an encoder the recording is in real time');
}

async function words(context) {
  const toy = shader({ type: 'image', name: 'Image', inputs: [], outputs: [], code: 'void mainImage(out vec4 O, vec2 U) { O = vec4(1.0); }' });
  toy.info.description = 'a &lt;b&gt; &amp; c &eacute; [b]bold [i]both[/i][/b] [url=https://a.test/x?y=1&amp;z]there[/url] [url]https://b.test[/url], [img]https://c.test/p.png[/img] see https://d.test/q. [url=javascript:alert(1)]no[/url] [url=http://plain.test]old[/url] a[1] [/b] [code]x < y[/code]';
  const { page } = await show(context, 'words', toy, '#paused');
  await openTab(page, 'About');
  const seen = await page.evaluate(() => {
    const box = document.querySelector('#description');
    return {
      text: box.textContent,
      links: [...box.querySelectorAll('a')].map((a) => [a.href, a.textContent, a.rel]),
      marks: [...box.querySelectorAll('strong, em, code')].map((n) => [n.localName, n.textContent]),
    };
  });
  assert.equal(seen.text, 'a <b> & c é bold both there https://b.test, https://c.test/p.png see https://d.test/q. no old a[1] [/b] x < y');
  assert.deepEqual(seen.links, [
    ['https://a.test/x?y=1&z', 'there', 'noopener noreferrer'],
    ['https://b.test/', 'https://b.test', 'noopener noreferrer'],
    ['https://c.test/p.png', 'https://c.test/p.png', 'noopener noreferrer'],
    ['https://d.test/q', 'https://d.test/q', 'noopener noreferrer'],
  ]);
  assert.deepEqual(seen.marks, [['strong', 'bold both'], ['em', 'both'], ['code', 'x < y']]);
}

const PLAYGROUND = 'http://page.test/playground/';

/** What the page opens: the words of the fragment, and the shader in it. */
async function opened(context, act) {
  await context.route(`${PLAYGROUND}**`, (route) => route.fulfill({ body: 'the playground' }));
  const [other] = await Promise.all([context.waitForEvent('page'), act()]);
  await other.waitForURL(`${PLAYGROUND}**`);
  const { hash, search } = new URL(other.url());
  assert.equal(search, '');
  assert.equal(await other.evaluate(() => globalThis.opener), null);
  await other.close();
  const { code, ...words } = Object.fromEntries(new URLSearchParams(hash.slice(1)));
  return { words, text: zlib.inflateRawSync(Buffer.from(code, 'base64url')).toString() };
}

async function debugged(context) {
  const { page } = await show(context, 'debugged', MOVING, '#size=320x180&t=1.5&paused', '--playground', PLAYGROUND);
  const middle = await opened(context, () => page.click('#debug'));
  assert.equal(middle.text, MOVING);
  const frame = String(await page.evaluate(() => globalThis.shaderport.player.clock.shown));
  assert.deepEqual(middle.words, { debug: '', pixel: '160,90', size: '320x180', time: '1.5', frame });
  // The key takes the pixel under the mouse, and code and numbers as they are now.
  await page.evaluate(() => globalThis.shaderport.player.setCode(globalThis.shaderport.player.project.files.findIndex((file) => !file.hidden), 'void mainImage(out vec4 O, vec2 U) { O = vec4(0.5); }'));
  const box = await page.locator('canvas').boundingBox();
  await page.mouse.move(box.x + 10.5, box.y + 179.5);
  await page.mouse.down();
  await page.mouse.up();
  const under = await opened(context, () => page.keyboard.press('d'));
  assert.match(under.text, /vec4\(0\.5\)/);
  assert.equal(under.words.pixel, '10,0');
  assert.equal(under.words.mouse, '10,0');
}

async function debuggedPasses(context) {
  const code = (line) => `void mainImage(out vec4 O, vec2 U) { O = ${line}; }`;
  const sampler = { filter: 'linear', wrap: 'repeat' };
  const toy = shader(
    { type: 'image', name: 'Image', outputs: [{ id: '4dfGRr' }], code: code('texture(iChannel0, U) + texture(iChannel1, U) + texture(iChannel2, U)'),
      inputs: [{ id: 'XsXGR8', type: 'buffer', channel: 0, sampler }, { id: '4dXGRr', type: 'keyboard', channel: 1, sampler }, { id: '4dX3Rr', type: 'texture', channel: 2, src: '/media/a/x.jpg', sampler }] },
    { type: 'buffer', name: 'Buffer B', inputs: [], outputs: [{ id: 'XsXGR8' }], code: code('shared_()') },
    { type: 'common', name: 'Common', inputs: [], outputs: [], code: 'vec4 shared_() { return vec4(1.0); }' },
  );
  const { page } = await show(context, 'passes', toy, '#size=32x18&paused', '--playground', PLAYGROUND);
  const files = JSON.parse((await opened(context, () => page.click('#debug'))).text);
  const [image, buffer, common] = toy.renderpass.map((pass) => pass.code);
  assert.deepEqual(files, {
    'common.glsl': common,
    'image.glsl': image,
    'buffer_b.glsl': buffer,
    'channels.toml': '[image]\n0 = "buffer_b,linear,repeat"\n1 = "keyboard"\n',
  });
}

async function notDebugged(context) {
  const { page } = await show(context, 'no-playground', MOVING, '#paused');
  assert.equal(await page.locator('#debug').count(), 0);
  await page.keyboard.press('?');
  assert.doesNotMatch(await page.locator('#keys').innerText(), /Debug/);
}

export const exportTests = [
  { name: 'page: the frame is saved as an image', run: shot, context: desk },
  { name: 'page: frames are recorded exactly, with sound', run: exactFilm, context: desk },
  { name: 'page: a stopped recording is saved', run: stopped, context: desk },
  { name: 'page: recordings work in real time', run: liveFilm, context: desk },
  { name: 'page: the debugger of the playground opens at a pixel', run: debugged, context: desk },
  { name: 'page: the debugger gets all passes and their channels', run: debuggedPasses, context: desk },
  { name: 'page: without a playground no debugger is offered', run: notDebugged, context: desk },
  { name: 'page: descriptions are text and links', run: words, context: desk },
];

// Images, recordings, and the author of the shader.
import assert from 'node:assert/strict';
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
  const { page, complaints } = await show(context, 'film', toy, '#t=3&paused');
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
  assert.deepEqual(complaints, []);
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
  const { page, complaints } = await show(context, 'words', toy, '#paused');
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
  assert.deepEqual(complaints, []);
}

export const exportTests = [
  { name: 'page: saving an image', run: shot, context: desk },
  { name: 'page: recording frame by frame, with sound', run: exactFilm, context: desk },
  { name: 'page: a stopped recording', run: stopped, context: desk },
  { name: 'page: recording in real time', run: liveFilm, context: desk },
  { name: 'page: descriptions are text and links', run: words, context: desk },
];

// The page draws the same pixels as the reference player.
import assert from 'node:assert/strict';
import { CASES } from './cases.js';
import { colors, differences, frame, open, port, put } from './browser.js';
import { reference } from './reference.js';

const SIZE = { width: 64, height: 36 };
const DATE = [2024, 4, 6];
const SECONDS = 4321;

/** Sets mouse and keys to the state of a case in frame 0. */
function touch(page, { mouse, keys }) {
  return page.evaluate(
    (job) => {
      const api = globalThis.shaderport;
      for (const key of job.keys ?? []) {
        api.setKey(key, false);
        // A second press reverts the toggle of an earlier frame.
        if (api.player.keyboard.data[512 + key]) {
          api.setKey(key, true);
          api.setKey(key, false);
        }
        api.setKey(key, true);
      }
      if (!job.mouse) return;
      api.setMouse(0, 0, false);
      api.setMouse(job.mouse.x, job.mouse.y, true);
    },
    { mouse, keys },
  );
}

/**
 * The page of a case draws the same as the reference player. @param {string} [file] path of its export, if it
 * exists
 */
export async function compare(context, test, file = put('case.json', JSON.stringify(test.shader))) {
  const { page } = await open(context, await port(file, 'case'), `#size=${SIZE.width}x${SIZE.height}&paused`);
  await page.clock.setFixedTime(new Date(...DATE, 0, 0, SECONDS));
  const blank = await context.newPage();
  await page.evaluate(() => globalThis.shaderport.ready);
  for (const last of test.frames) {
    const job = { ...SIZE, shader: test.shader, last, mouse: test.mouse, keys: test.keys, date: [...DATE, SECONDS] };
    const expected = await reference(blank, job);
    await touch(page, test);
    const drawn = await frame(page, last);
    assert.equal(differences(drawn, expected), 0, `frame ${last} has different pixels`);
    if (!test.flat) assert.ok(colors(drawn) > 1, `frame ${last} has a single colour`);
  }
  assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), []);
}

export const pixelTests = CASES.flatMap((test) => {
  const name = `pixels: ${test.name}`;
  const first = { name, run: (context) => compare(context, test) };
  const { later } = test;
  if (!later) return [first];
  return [first, { name: `${name}, later`, only: 'heavy', run: (context) => compare(context, { ...test, frames: later }) }];
});

// Chromium draws ShaderToy exports like `shaderlint` does. A frame that differs is unsettled if GPU
// profiles with the lowest precision of the conformance suite draw at least as many pixels differently,
// including most of those that differ: noise computed from sines is an example. Any other difference is
// an error of one side.
//
//   node exports.js FILE.json...   prints a line for each frame that differs, and a count
//   FUZZ=PATH                      the fuzzer, which prints what `shaderlint` draws
//   KEEP=FOLDER                    stores both images as JSON if they differ
import { execFile } from 'node:child_process';
import { once } from 'node:events';
import fs from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';
import { frame, launch, open, port, top } from './browser.js';

/** Time limit for an image in seconds, on either side. */
const PATIENCE = 60;

/** Share of the pixels that must be equal, within 1/255. */
const ENOUGH = 0.999;

const fuzz = process.env.FUZZ ?? path.join(top, 'target/debug/shaderlint-fuzz');

/**
 * @typedef {{number: number, pixels: number[], wrong: string[]}} Frame
 * @typedef {{why?: string, size: number[], frames: Frame[]}} Pictures
 * @typedef {{why?: string, unsettled: boolean[][]}} Unsettled
 */

/** Output of the fuzzer for an export. */
async function asked(what, file) {
  const limits = { timeout: 1000 * PATIENCE, maxBuffer: 1 << 28 };
  const { stdout } = await promisify(execFile)(fuzz, [what, file], limits);
  return JSON.parse(stdout);
}

/** What Chromium draws for an export, by frame. */
async function theirs(browser, file, { size, frames }) {
  const context = await browser.newContext();
  context.setDefaultTimeout(1000 * PATIENCE);
  await context.clock.setFixedTime(new Date(2000, 0, 1));
  const address = await port(file, path.basename(file, '.json'));
  const { page } = await open(context, address, `#size=${size.join('x')}&paused`);
  await page.evaluate(() => globalThis.shaderport.ready);
  const drawn = [];
  for (const { number } of frames) drawn.push(await frame(page, number));
  await context.close();
  return drawn;
}

/** Which pixels differ. */
function differs({ pixels }, other) {
  const far = (i) => [0, 1, 2].some((k) => Math.abs(pixels[3 * i + k] - other[4 * i + k]) > 1);
  return Array.from({ length: other.length / 4 }, (_, i) => far(i));
}

const count = (all) => all.filter(Boolean).length;
const isEnough = (wrong, all) => wrong <= (1 - ENOUGH) * all;

/** Compares the frames of an export; resolves to a line for each. */
async function compared(browser, file) {
  /** @type {Pictures} */
  const ours = await asked('played', file);
  if (ours.why) return [{ kind: 'refused', text: ours.why }];
  const drawn = await theirs(browser, file, ours);
  const wrong = ours.frames.map((one, i) => differs(one, drawn[i]));
  /** @type {Unsettled | null} */
  const known = wrong.every((w) => isEnough(count(w), w.length)) ? null : await asked('unsettled', file);
  return ours.frames.map((one, i) => {
    const [all, bad] = [wrong[i].length, count(wrong[i])];
    if (isEnough(bad, all)) return { kind: 'same', text: '' };
    const unsettled = known?.unsettled?.[i] ?? [];
    if (process.env.KEEP) {
      const kept = JSON.stringify({ ...one, unsettled, theirs: drawn[i] });
      fs.writeFileSync(path.join(process.env.KEEP, `${path.basename(file, '.json')}.${one.number}.json`), kept);
    }
    const open = count(wrong[i].filter((is, n) => is && unsettled[n]));
    const kind = 2 * open >= bad && count(unsettled) >= bad ? 'unsettled' : 'other';
    const text = `${bad} of ${all} pixels differ, ${bad - open} of them settled (${all - count(unsettled)} are)`;
    return { kind, text: `frame ${one.number}: ${text}; ${one.wrong.join(', ')}` };
  });
}

/** Resolves like a promise, unless that takes too long. */
function within(seconds, promise) {
  const late = once(AbortSignal.timeout(1000 * seconds), 'abort').then(() => { throw new Error('timeout'); });
  return Promise.race([promise, late]);
}

let running = await launch();
/** @type {Record<string, number>} */
const counts = {};
for (const file of process.argv.slice(2)) {
  let lines;
  try {
    lines = await within(3 * PATIENCE, compared(running.browser, file));
  } catch (error) {
    lines = [{ kind: 'late', text: String(error).split('\n')[0] }];
    await running.kill();
    running = await launch();
  }
  for (const { kind, text } of lines) {
    counts[kind] = (counts[kind] ?? 0) + 1;
    if (kind !== 'same') console.log(`${kind.padEnd(9)} ${path.basename(file)} ${text}`);
  }
}
console.log(counts);
await running.kill();
process.exit(counts.other ? 1 : 0);

// Templates, and the exports in SHADERLINT_CASES: the pages of light shaders must draw the same as the
// reference player; with --all, each page must load, draw, and move if the shader uses time.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { colors, complaints, differences, frame, open, pixels, port, program, run, top } from './browser.js';
import { compare } from './pixels.js';
import { options } from './suite.js';

/** The shaders of corpus/templates. */
export function templates() {
  const folder = path.join(top, 'corpus/templates');
  return fs.readdirSync(folder).filter((f) => f.endsWith('.glsl')).map((f) => path.join(folder, f));
}

/** The exports in SHADERLINT_CASES, if any. */
export function exportsOf() {
  const folder = process.env.SHADERLINT_CASES && path.join(process.env.SHADERLINT_CASES, 'shadertoy');
  if (!folder || !fs.existsSync(folder)) return [];
  return fs.readdirSync(folder).filter((f) => f.endsWith('.json')).sort().map((f) => path.join(folder, f));
}

/** The exports that a sweep draws: every EVERYth. */
export const sweptExports = (files = exportsOf()) => files.filter((_, i) => i % Number(process.env.EVERY ?? 1) === 0);

/** The exports that are compiled: all with --all, otherwise a sample. */
export const compiledExports = () => (options.all ? exportsOf() : sweptExports());

/** The content of an export. */
export const read = (file) => [JSON.parse(fs.readFileSync(file, 'utf8'))].flat()[0];

/** Number of light exports that are always drawn. */
const CHOSEN = 16;

/** Limit of a light export: operations of all passes for a frame of 64x36 pixels. */
const LIGHT = 10_000_000;

/** Limit of a light export: characters of all passes, because code that does not run is compiled, too. */
const SHORT = 6000;

/** Whether an export is short, uses only what the reference player supports, and has no pass larger than the image. */
function isPlain({ renderpass }) {
  if (renderpass.map((p) => p.code).join('').length > SHORT) return false;
  const drawn = renderpass.filter((p) => p.type === 'image' || p.type === 'buffer');
  const others = renderpass.filter((p) => p.type === 'cubemap');
  return others.length === 0 && drawn.flatMap((p) => p.inputs).every((i) => i.type === 'buffer' || i.type === 'keyboard');
}

/** The number of operations that the VM counts for a frame of all passes; `Infinity` if it cannot draw one. */
async function operations(file) {
  const { renderpass } = read(file);
  const letters = [...renderpass.filter((p) => p.type === 'buffer')].map((p, i) => (/^Buf(?:fer)? ?([A-D])$/i.exec(p.name)?.[1] ?? 'ABCD'[i]).toLowerCase());
  let sum = 0;
  for (const pass of ['image', ...letters.map((l) => `buffer_${l}`)]) {
    const { code, stdout } = await run(program('shaderlint'), 'run', file, '--size', '64x36', '--pass', pass, '--format', 'json');
    if (code !== 0) return Infinity;
    sum += JSON.parse(stdout).cost.operations;
    if (sum > LIGHT) break;
  }
  return sum;
}

/** @type {Promise<string[]> | null} */
let light = null;

/** The light exports that are always drawn: the first ones in an order that depends only on their text. */
export function lightExports() {
  light ??= chooseLight();
  return light;
}

async function chooseLight() {
  const digest = (file) => createHash('sha256').update(fs.readFileSync(file)).digest('hex');
  const order = exportsOf().filter((file) => isPlain(read(file))).map((file) => ({ file, key: digest(file) }));
  order.sort((a, b) => (a.key < b.key ? -1 : 1));
  const chosen = [];
  for (let at = 0; at < order.length && chosen.length < CHOSEN; at += 4) {
    const some = order.slice(at, at + 4);
    const counts = await Promise.all(some.map(({ file }) => operations(file)));
    chosen.push(...some.filter((_, i) => counts[i] <= LIGHT).map(({ file }) => file));
  }
  return chosen.slice(0, CHOSEN);
}

/** Waits for a page and draws its first frame. */
async function firstFrame({ page }) {
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), [], 'all passes compile');
  return frame(page, 0);
}

async function template(context, file) {
  const code = fs.readFileSync(file, 'utf8');
  const opened = await open(context, await port(file, path.basename(file, '.glsl')), '#size=32x18&paused');
  const first = await firstFrame(opened);
  const later = await frame(opened.page, 12);
  assert.ok(colors(later) > 10, 'the page draws');
  if (code.includes('iTime')) assert.ok(differences(first, later) > 0, 'the image changes over time');
}

/** Exports that use time, and those of them that look the same at all sampled times. */
const moving = { asked: 0, still: [] };

/** Whether the image at some later time differs from the first. */
async function moves(page, first) {
  for (const time of [0.7, 3.1, 12.4]) {
    await page.evaluate((t) => globalThis.shaderport.seek(t), time);
    if (differences(first, await pixels(page)) > 0) return true;
  }
  return false;
}

/** Exports that crashed the GPU process or the browser, without an error of the shader. */
const lost = [];

async function exported(context, file, name) {
  const opened = await open(context, await port(file, name), '#size=32x18&paused');
  try {
    const first = await firstFrame(opened);
    const code = read(file).renderpass.filter((p) => p.type !== 'sound').map((p) => p.code).join('\n');
    const usesTime = /\biTime\b/.test(code.replace(/\/\/.*|\/\*[^]*?\*\//g, ''));
    // A uniform image here means missing textures, or computations with undefined values.
    const asked = usesTime && colors(first) > 1;
    const isMoving = await moves(opened.page, first);
    if (asked) moving.asked++;
    if (asked && !isMoving) moving.still.push(name);
    assert.deepEqual(complaints(), []);
  } catch (error) {
    const isLost = complaints().some((c) => c.includes('CONTEXT_LOST_WEBGL')) || !context.browser().isConnected();
    if (!isLost) throw error;
    lost.push(name);
  }
}

function fewAreLost(count) {
  assert.ok(lost.length <= Math.max(2, 0.03 * count), `${lost.length} of ${count}: ${lost.join(' ')}`);
}

/** Some shaders use time only for what appears later, or after a key is pressed. */
function mostMove() {
  const most = Math.max(3, 0.15 * moving.asked);
  assert.ok(moving.asked > 0 && moving.still.length <= most, `${moving.still.length} of ${moving.asked} do not move: ${moving.still.join(' ')}`);
}

const SWEEP = 'a sweep; a sample is always compiled';

/** The tests of the templates, and of the exports if there are any. */
export async function corpusTests() {
  const nameOf = (file) => path.basename(file, '.json');
  const tests = templates().map((file) => ({ name: `template: ${path.basename(file)}`, run: (context) => template(context, file) }));
  for (const file of await lightExports()) {
    const toy = read(file);
    const run = (context) => compare(context, { shader: toy, frames: [2], flat: true }, file);
    tests.push({ name: `export, compared with the reference player: ${nameOf(file)}`, run });
  }
  const swept = sweptExports();
  if (swept.length === 0) return tests;
  const sweep = swept.map((file) => ({ name: `export: ${nameOf(file)}`, only: SWEEP, mayComplain: true, run: (context) => exported(context, file, nameOf(file)) }));
  return [
    ...tests,
    ...sweep,
    { name: 'exports: few exceed the GPU', only: SWEEP, isLast: true, run: () => fewAreLost(swept.length) },
    { name: 'exports: animated exports change over time', only: SWEEP, isLast: true, run: mostMove },
  ];
}

// The templates, and the exports in SHADERLINT_CASES: what the pages of light ones draw is what the
// reference player draws; with --all, each page loads, draws, and moves where the shader uses time.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { colors, differences, frame, open, pixels, port, program, run, top } from './browser.js';
import { compare } from './pixels.js';

/** The shaders of corpus/templates. */
export function templates() {
  const folder = path.join(top, 'corpus/templates');
  return fs.readdirSync(folder).filter((f) => f.endsWith('.glsl')).map((f) => path.join(folder, f));
}

/** The exports in SHADERLINT_CASES; of none, where there are none. */
export function exportsOf() {
  const folder = process.env.SHADERLINT_CASES && path.join(process.env.SHADERLINT_CASES, 'shadertoy');
  if (!folder || !fs.existsSync(folder)) return [];
  return fs.readdirSync(folder).filter((f) => f.endsWith('.json')).sort().map((f) => path.join(folder, f));
}

/** Those of them that a sweep draws: every so many. */
export const sweptExports = (files = exportsOf()) => files.filter((_, i) => i % Number(process.env.EVERY ?? 1) === 0);

/** What an export holds. */
export const read = (file) => [JSON.parse(fs.readFileSync(file, 'utf8'))].flat()[0];

/** Light exports that are drawn always. */
const CHOSEN = 16;

/** Operations of all passes for a frame of 64x36 pixels, up to which an export is light. */
const LIGHT = 10_000_000;

/** Characters of all passes, up to which it is: what is not run is compiled. */
const SHORT = 6000;

/** Whether an export is short, the reference player knows all that it reads, and no pass is larger than the picture. */
function isPlain({ renderpass }) {
  if (renderpass.map((p) => p.code).join('').length > SHORT) return false;
  const drawn = renderpass.filter((p) => p.type === 'image' || p.type === 'buffer');
  const others = renderpass.filter((p) => p.type === 'cubemap');
  return others.length === 0 && drawn.flatMap((p) => p.inputs).every((i) => i.type === 'buffer' || i.type === 'keyboard');
}

/** How many operations the executor counts for a frame of all passes; none, where it cannot draw one. */
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

/** The light exports that are drawn always: the first in an order that nothing but their text decides. */
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

/** Waits for a page, and draws its first frame. */
async function firstFrame({ page, complaints }) {
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), [], 'every pass compiles');
  const first = await frame(page, 0);
  assert.deepEqual(complaints, []);
  return first;
}

async function template(context, file) {
  const code = fs.readFileSync(file, 'utf8');
  const opened = await open(context, await port(file, path.basename(file, '.glsl')), '#size=32x18&paused');
  const first = await firstFrame(opened);
  const later = await frame(opened.page, 12);
  assert.ok(colors(later) > 10, 'it draws');
  if (code.includes('iTime')) assert.ok(differences(first, later) > 0, 'it moves');
  assert.deepEqual(opened.complaints, []);
}

/** Exports that use the time, and those of them whose picture is the same at all times looked at. */
const moving = { asked: 0, still: [] };

/** Whether the picture at some later time differs from the first. */
async function moves(page, first) {
  for (const time of [0.7, 3.1, 12.4]) {
    await page.evaluate((t) => globalThis.shaderport.seek(t), time);
    if (differences(first, await pixels(page)) > 0) return true;
  }
  return false;
}

/** Exports of which the process that draws has died, or the browser with it, and not of the shader's mistakes. */
const lost = [];

async function exported(context, file, name) {
  const opened = await open(context, await port(file, name), '#size=32x18&paused');
  try {
    const first = await firstFrame(opened);
    const code = read(file).renderpass.filter((p) => p.type !== 'sound').map((p) => p.code).join('\n');
    const usesTime = /\biTime\b/.test(code.replace(/\/\/.*|\/\*[^]*?\*\//g, ''));
    // One that is of one colour here lacks its textures, or computes what has no value.
    const asked = usesTime && colors(first) > 1;
    const isMoving = await moves(opened.page, first);
    if (asked) moving.asked++;
    if (asked && !isMoving) moving.still.push(name);
    assert.deepEqual(opened.complaints, []);
  } catch (error) {
    const isLost = opened.complaints.some((c) => c.includes('CONTEXT_LOST_WEBGL')) || !context.browser().isConnected();
    if (!isLost) throw error;
    lost.push(name);
  }
}

function fewAreLost(count) {
  assert.ok(lost.length <= Math.max(2, 0.03 * count), `${lost.length} of ${count}: ${lost.join(' ')}`);
}

/** Some shaders use the time only for what is seen later, or when a button is pressed. */
function mostMove() {
  const most = Math.max(3, 0.15 * moving.asked);
  assert.ok(moving.asked > 0 && moving.still.length <= most, `${moving.still.length} of ${moving.asked} stand still: ${moving.still.join(' ')}`);
}

const SWEEP = 'a sweep; that they compile is tested always';

/** The tests of the templates, and of the exports where there are any. */
export async function corpusTests() {
  const nameOf = (file) => path.basename(file, '.json');
  const tests = templates().map((file) => ({ name: `template: ${path.basename(file)}`, run: (context) => template(context, file) }));
  for (const file of await lightExports()) {
    const toy = read(file);
    const run = (context) => compare(context, { shader: toy, frames: [2], flat: true }, file);
    tests.push({ name: `export, beside the reference player: ${nameOf(file)}`, run });
  }
  const swept = sweptExports();
  if (swept.length === 0) return tests;
  const sweep = swept.map((file) => ({ name: `export: ${nameOf(file)}`, only: SWEEP, run: (context) => exported(context, file, nameOf(file)) }));
  return [
    ...tests,
    ...sweep,
    { name: 'exports: few are too much for the GPU', only: SWEEP, isLast: true, run: () => fewAreLost(swept.length) },
    { name: 'exports: those that use the time move', only: SWEEP, isLast: true, run: mostMove },
  ];
}

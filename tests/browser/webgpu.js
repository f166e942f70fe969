// Compares WGSL drawn by WebGPU with the page drawn by WebGL, pixel by pixel.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { bytesOf, colors, excuse, folder, open, port, program, put, run, shaderport, top } from './browser.js';
import { exportsOf, lightExports, read, sweptExports, templates } from './corpus.js';
import { beside } from './webgpu_host.js';

/** The converter, built with the target languages of naga. */
export const CONVERTER = process.env.SHADERPORT_WGSL || program('shaderport');

const SIZE = { width: 64, height: 36 };
/** The compared frame; earlier frames are drawn, too. */
const LAST = 6;

/** The number of pixels that differ by more than two steps of a colour; two compilers may differ in rounding. */
export function unequal(a, b) {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a[i + c] - b[i + c]) > 2)) count++;
  }
  return count;
}

/** The browser's GPU process has ended, and with it everything it drew. */
class Ended extends Error {}

/** Whether it has ended: pending requests to that process fail with this message. */
function hasEnded() {
  const { gl } = globalThis.shaderport.player;
  // The player gives up a context that was lost for good.
  if (!gl) return true;
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return gl.isContextLost();
}

/** Draws a shader or project in both ways; resolves to the number of pixels that differ, and the bytes drawn by WebGPU. */
async function compare(context, file, name, ...args) {
  const out = path.join(folder(), `${name}.wgsl.d`);
  fs.mkdirSync(out, { recursive: true });
  await run(CONVERTER, file, '-t', 'wgsl', '-o', out, '--interface', '--force', ...args);
  const shaders = fs.readdirSync(out).filter((f) => f.endsWith('.wgsl')).map((f) => path.join(out, f));
  const passes = shaders.map((shader) => ({
    code: fs.readFileSync(shader, 'utf8'),
    told: JSON.parse(fs.readFileSync(`${shader}.json`, 'utf8')),
  }));
  const { page } = await open(context, await port(file, name), `#size=${SIZE.width}x${SIZE.height}&paused`);
  await page.clock.setFixedTime(new Date('2024-05-06T07:08:09Z'));
  await page.evaluate(() => globalThis.shaderport.ready);
  const failed = (error) => ({ error: error.message });
  const drawn = await page.evaluate(beside, { passes, last: LAST }).catch(failed);
  if (drawn.error && (await page.evaluate(hasEnded))) throw new Ended(drawn.error);
  assert.equal(drawn.error, undefined);
  const [ours, theirs] = [drawn.ours, drawn.theirs].map(bytesOf);
  const shown = colors(theirs);
  return { count: unequal(ours, theirs), total: SIZE.width * SIZE.height, shown, ours };
}

const equal = { asked: 0, differing: [], tooMuch: [] };

/** Most exports look the same; the others are listed by name. */
function mostAreEqual() {
  const { asked, differing, tooMuch } = equal;
  const told = `${differing.length} of ${asked} differ: ${differing.join(' ')}; too much for the GPU: ${tooMuch.join(' ')}`;
  console.log(told);
  // One more may differ, so that a small sample does not fail because of a single export.
  assert.ok(differing.length <= 1 + 0.03 * asked, told);
  assert.ok(tooMuch.length <= 1 + 0.01 * asked, told);
}

async function exported(context, file, name) {
  // Flipped rows are in different quads, which changes derivatives.
  try {
    const { count, total } = await compare(context, file, name, '--first-row', 'bottom');
    equal.asked++;
    if (count > 0.001 * total) equal.differing.push(`${name} (${count})`);
  } catch (error) {
    if (!(error instanceof Ended) && context.browser().isConnected()) throw error;
    equal.tooMuch.push(name);
    excuse();
  }
}

/** Whether the program was built with the target languages of naga. */
export async function hasWgsl() {
  try {
    const probe = put('probe.glsl', 'void mainImage(out vec4 c, in vec2 f) { c = vec4(1); }\n');
    return (await run(CONVERTER, probe, '-o', path.join(folder(), 'probe.wgsl'), '--force')).code === 0;
  } catch {
    return false;
  }
}

/** Whether no pass of an export draws a cube map. */
const isFlat = (file) => read(file).renderpass.every((pass) => pass.type !== 'cubemap');

/** A project with passes that read themselves, each other and a missing file. */
const PASSES = {
  buffer_a: `void mainImage(out vec4 c, in vec2 p) {
    vec4 old = texelFetch(iChannel0, ivec2(p), 0);
    vec2 away = p - iResolution.xy * (0.5 + 0.3 * vec2(cos(iTime * 9.), sin(iTime * 9.)));
    c = old * 0.8 + vec4(exp(-dot(away, away) / 20.), old.x, float(iFrame), old.w + 1.);
    if (iFrame > 2) c.x += 0.25 * texture(iChannel0, (p + vec2(0, 1)) / iResolution.xy).x;
}`,
  buffer_b: `void mainImage(out vec4 c, in vec2 p) {
    vec4 now = texture(iChannel0, p / iResolution.xy), before = texture(iChannel1, p.yx / iResolution.yx);
    c = mix(now, before, 0.25) + 0.001 * iChannelResolution[0].xyxy;
}`,
  image: `void mainImage(out vec4 c, in vec2 p) {
    vec2 uv = p / iResolution.xy;
    vec4 b = texture(iChannel0, uv * 0.9 + 0.07), t = texture(iChannel1, uv * 3.);
    c = vec4(b.x, fract(b.w), t.x + texelFetch(iChannel2, ivec2(32, 0), 0).x, 1);
    c.rg += dFdy(b.xy) + 0.1 * step(p.y, 4.) + float(textureSize(iChannel1, int(p.x) / 9).x) / 2048.;
}`,
};

/** Every pass is drawn with the results of the previous ones, rows flipped or not. */
async function passes(context) {
  const reads = ['buffer_a.0=buffer_a,linear,clamp', 'buffer_b.0=buffer_a,nearest', 'buffer_b.1=buffer_b,linear'];
  reads.push('image.0=buffer_b,linear', 'image.2=keyboard');
  const sources = path.join(folder(), 'gpu_passes');
  for (const [name, code] of Object.entries(PASSES)) put(`gpu_passes/${name}.glsl`, `${code}\n`);
  const channels = reads.flatMap((read) => ['--channel', read]);
  const json = path.join(folder(), 'gpu_passes.json');
  await shaderport(sources, '-o', json, '--force', ...channels);
  const made = [JSON.parse(fs.readFileSync(json, 'utf8'))].flat()[0];
  const stones = { id: '4dfGRn', filepath: '/media/a/x.jpg', type: 'texture', channel: 1 };
  const image = made.renderpass.find((pass) => pass.type === 'image');
  image.inputs.push({ ...image.inputs[0], ...stones, sampler: { filter: 'linear', wrap: 'repeat', vflip: 'true' } });
  const file = put('gpu_passes_read.json', JSON.stringify(made));
  for (const row of ['top', 'bottom']) {
    const { count, total, shown } = await compare(context, file, `gpu_passes_${row}`, '--first-row', row);
    assert.ok(count <= 0.001 * total, `${row}: ${count} of ${total} pixels differ`);
    assert.ok(shown > 200, `${shown} colours are visible`);
  }
}

/** The cases of the executor's tests of the order of evaluation: statements that set `r`, and its value. */
function orderCases() {
  const text = fs.readFileSync(path.join(top, 'tests/units/exec/evaluation_order.rs'), 'utf8');
  const head = /const HEAD: &str = "#version 300 es\n.*\n([^"]*)\\n";/.exec(text)[1];
  const rows = fs.readFileSync(path.join(top, 'tests/units/exec/evaluation_order.txt'), 'utf8');
  const cases = [...rows.matchAll(/^([^#\n][^\n]*) => (\d+)$/gm)];
  return { head, cases: cases.map(([, statements, value]) => ({ statements, value: Number(value) })) };
}

/** Each case in its own pixel, with the global variables as at the start. */
async function order(context) {
  const { head, cases } = orderCases();
  const start = 'g = 1; log = 0; a = int[4](0, 0, 0, 0); v = ivec4(0); s = S(0, ivec2(0), int[3](0, 0, 0));';
  const functions = cases.map(({ statements }, i) => `int case${i}() { int r = 0, i = 1, x = 1; ${start} ${statements} return r; }`);
  const calls = cases.map((_, i) => `case ${i}: r = case${i}(); break;`);
  const main = `void mainImage(out vec4 c, in vec2 p) {
  int r = 0;
  switch (int(p.x) + ${SIZE.width} * int(p.y)) {
    ${calls.join('\n    ')}
  }
  c = vec4(r & 255, r >> 8, 0, 255) / 255.0;
}`;
  const file = put('gpu_order.glsl', [head, ...functions, main, ''].join('\n'));
  const { count, ours } = await compare(context, file, 'gpu_order');
  assert.equal(count, 0);
  assert.ok(cases.length > 70, `${cases.length} cases`);
  cases.forEach(({ statements, value }, i) => assert.equal(ours[4 * i] + 256 * ours[4 * i + 1], value, statements));
}

/** A function that some pixels leave before derivatives are taken: these use the values of all pixels. */
async function returns(context) {
  const file = put('gpu_returns.glsl', `float f(inout vec2 p) {
  if (p.x < 0.0 || p.x > 1.0) { p.x -= 0.41; return 0.0; }
  vec2 d = dFdx(p);
  p.x -= 0.41;
  return 0.5 * length(d) + fwidth(p.y);
}
void mainImage(out vec4 c, in vec2 q) {
  vec2 p = q / 15.0;
  float sum = 0.0;
  for (int i = 0; i < 9; i++) sum += f(p);
  c = vec4(sum, p * 0.1 + 0.5, 1);
}
`);
  const { count, shown } = await compare(context, file, 'gpu_returns', '--first-row', 'bottom');
  assert.equal(count, 0);
  assert.ok(shown > 100, `${shown} colours are visible`);
}

/** Built-in functions that WebGPU's compiler would compute with another rounding; colours are the last bits. */
async function rounding(context) {
  const file = put('gpu_rounding.glsl', `vec3 bits(float x) {
  uint b = floatBitsToUint(x);
  return vec3(b & 7u, (b >> 3) & 7u, (b >> 6) & 7u) / 7.0;
}
float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43.5453); }
void mainImage(out vec4 c, in vec2 p) {
  float x = random(p), y = random(p.yx), z = random(p + 0.5);
  mat3 m = mat3(x, y, 1, z, x + 1.0, y, 0, z, x);
  vec4 v = smoothstep(vec4(z), vec4(-x), vec4(y, x, 0.1, 0.2));
  float[6] all = float[6](smoothstep(x, x + 0.7, y), smoothstep(x, -1.0, y), v.y, (m / z)[1].y, inverse(mat2(m))[0].x, inverse(m)[1].y);
  c = vec4(bits(all[int(p.x) % 6]), 1);
}
`);
  const { count, shown } = await compare(context, file, 'gpu_rounding', '--first-row', 'bottom');
  assert.equal(count, 0);
  assert.ok(shown > 100, `${shown} colours are visible`);
}

/** The tests, if the program can write WGSL. */
export async function webgpuTests() {
  if (!(await hasWgsl())) {
    if (process.env.SHADERPORT_WGSL) throw new Error(`${CONVERTER} writes no WGSL`);
    return [];
  }
  const tests = templates().map((file) => ({
    name: `webgpu: ${path.basename(file)}`,
    run: async (context) => {
      const { count, total } = await compare(context, file, `gpu_${path.basename(file, '.glsl')}`);
      assert.ok(count <= 0.001 * total, `${count} of ${total} pixels differ`);
    },
  }));
  tests.push({ name: 'webgpu: passes may read each other', run: passes });
  tests.push({ name: 'webgpu: operands are evaluated in the order of WebGL', run: order });
  tests.push({ name: 'webgpu: derivatives after a return are those of WebGL', run: returns, mayComplain: true });
  tests.push({ name: 'webgpu: built-in functions round as in WebGL', run: rounding });
  const light = await lightExports();
  const swept = sweptExports(exportsOf().filter(isFlat));
  for (const file of new Set([...light, ...swept])) {
    const name = path.basename(file, '.json');
    const only = light.includes(file) ? undefined : 'a sweep';
    tests.push({ name: `webgpu export: ${name}`, only, run: (context) => exported(context, file, name) });
  }
  if (light.length + swept.length > 0) tests.push({ name: 'webgpu: most exports look the same', run: mostAreEqual, isLast: true });
  return tests;
}

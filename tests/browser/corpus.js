// The templates, and the exports in SHADERLINT_CASES: each page loads, draws, and moves where the
// shader uses time.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { colors, differences, frame, open, pixels, port, put, shaderport, top, work } from './browser.js';

const templates = path.join(top, 'corpus/templates');

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
  const opened = await open(context, port(file, path.basename(file, '.glsl')), '#size=32x18&paused');
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

async function exported(context, file, name) {
  const opened = await open(context, port(file, name), '#size=32x18&paused');
  try {
    const first = await firstFrame(opened);
    const { renderpass } = [JSON.parse(fs.readFileSync(file, 'utf8'))].flat()[0];
    const code = renderpass.filter((p) => p.type !== 'sound').map((p) => p.code).join('\n');
    const usesTime = /\biTime\b/.test(code.replace(/\/\/.*|\/\*[^]*?\*\//g, ''));
    // One that is of one colour here lacks its textures, or computes what has no value.
    const asked = usesTime && colors(first) > 1;
    const isMoving = await moves(opened.page, first);
    if (asked) moving.asked++;
    if (asked && !isMoving) moving.still.push(name);
    assert.deepEqual(opened.complaints, []);
  } catch (error) {
    // The process that draws has died, and not of the shader's mistakes.
    if (!opened.complaints.some((c) => c.includes('CONTEXT_LOST_WEBGL'))) throw error;
    slow.push(name);
  }
}

/** Exports that a browser without a graphics card cannot draw in time. */
const slow = [];
let count = 0;

function fewAreSlow() {
  assert.ok(slow.length <= Math.max(2, 0.03 * count), `${slow.length} of ${count}: ${slow.join(' ')}`);
}

/** Some shaders use the time only for what is seen later, or when a button is pressed. */
function mostMove() {
  const most = Math.max(3, 0.15 * moving.asked);
  assert.ok(moving.asked > 0 && moving.still.length <= most, `${moving.still.length} of ${moving.asked} stand still: ${moving.still.join(' ')}`);
}

/** Compiles every shader that `--main rewrite` calls safe. */
async function rewritten(context, files) {
  const page = await context.newPage();
  const wrong = [];
  let count = 0;
  for (const file of files) {
    const out = path.join(work, 'rewritten');
    fs.rmSync(out, { recursive: true, force: true });
    shaderport(file, '-t', 'glsl', '--main', 'rewrite', '-o', out, '--force');
    const shaders = fs.statSync(out).isDirectory() ? fs.readdirSync(out).map((f) => path.join(out, f)) : [out];
    const texts = shaders.map((f) => fs.readFileSync(f, 'utf8')).filter((t) => /\nvoid main\(\)/.test(t) && !t.includes('in vec2 pos'));
    count += texts.length;
    const logs = await page.evaluate((all) => {
      const gl = document.createElement('canvas').getContext('webgl2');
      const said = all.map((text) => {
        const shader = gl.createShader(gl.FRAGMENT_SHADER);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        return gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : gl.getShaderInfoLog(shader);
      });
      gl.getExtension('WEBGL_lose_context').loseContext();
      return said.filter(Boolean);
    }, texts);
    wrong.push(...logs.map((log) => `${path.basename(file)}: ${log}`));
  }
  assert.deepEqual(wrong, []);
  assert.ok(count > 0);
}

/** Bodies of `mainImage` in which one thing or another is in the way of a plain `main`. */
const BODIES = [
  '{ vec2 uv = p / iResolution.xy; c.rgb = vec3(uv, 0.5); c += 0.125; }',
  '{ for (int i = 0; i < 4; i++) c[i] = fract(p.x * 0.01 * float(i + 1)); }',
  '{ if (p.x > 30.0) c = vec4(p.y / 40.0); }',
  '{ p /= iResolution.xy; c = vec4(p, p[int(p.x * 2.0)], 1); }',
  '{ c = vec4(a, p.x / 64.0, 0, 1); }\n#define a 0.5',
  '{\n#define a 0.5\n#define xy yx\n c = vec4(p / 64.0, a, 1); }',
  '{ c = vec4(float(__LINE__ + int(p.x)) / 255.0); }',
  '{ half_of(c); c.zw = p / 64.0; { vec4 c = vec4(2); c.x = 1.0; } }',
  '{ halves(c.zx); c.y = p.x / 64.0; halves(p); c.w = p.y / 64.0; }',
  '{ c = vec4(p / 64.0, 0, 1); both(c.x, c); both(c.y, c); }',
  '{ lit(c, p); lit(c, p.yx); }',
  '{ for (int i = 0; i < 20; i++) { c.r += 0.05; if (float(i) * 4.0 > p.x) return; c.g += 0.03; } c.b = 1.0; }',
  '{ c = vec4(p / 64.0, 1, 0.5); if (mod(p.x, 20.0) < 10.0) discard; c.b = c.a; }',
  '{ p[0] *= 0.5; p[int(p.y) % 2] += 3.0; c = vec4(p / 64.0, c.x++, 1); c.wzyx = c; }',
  '{ float k = (c.x = p.x / 64.0) + (c.y = 0.3); c.z = k; for (int p = 0; p < 3; p++) c.b += float(p) * 0.1; }',
];

/** Functions that the bodies call. */
const CALLED = `
void half_of(inout vec4 x) { x.xy += 0.5; }
void halves(inout vec2 x) { x = x * 0.5 + 0.1; }
void both(inout float x, inout vec4 all) { x += 0.25; all.y += x; all.z += 0.1; }
void lit(inout vec4 x, vec2 at) { x.xy += at / 90.0; x.w = x.z; x.z += 0.2; }
`;

/** Whole shaders in which `mainImage` is declared, called or spelled in another way. */
const SPELLED = [
  'void mainImage(out vec4 c, in vec2 p);\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(p / 64.0, 0, 1); }',
  'void mainImage(out vec4 c, in vec2 p) { c = vec4(p / 64.0, 0, 1); }\nvoid other() { vec4 k; mainImage(k, vec2(0)); }',
  'vec2 at() { return gl_FragCoord.xy; }\nvoid mainImage(out vec4 c, vec2) { c = vec4(at() / 64.0, 0, 1); }',
  'vec4 c = vec4(0.2);\nvec4 get() { return c; }\nvoid mainImage(out vec4 c, vec2 p) { c = vec4(p / 64.0, 0, 1) + get(); }',
  'void mainImage(out highp vec4 c, in mediump vec2 p) { c = vec4(p / 64.0, 0.4, 1); }',
  ...['r', 'x', 'xy', 'main', 'fragColor', 'outColor'].map(
    (name) => `#define ${name} 0.5\nvoid mainImage(out vec4 o, vec2 u) { o = vec4(u / 64.0, ${name}, 0.3); }`,
  ),
  '#define U (u / iResolution.xy)\nvoid mainImage(out vec4 o, vec2 u) { o = vec4(U, 0.2, 1); u = U; o.z = u.x; }',
];

/** The passes that are written for a plain `main`, numbered. */
function rewrittenCodes() {
  const codes = BODIES.map((body) => {
    const macro = body.includes('a,') && !body.includes('{\n#define a') ? '#define a 0.5\n' : '';
    return `${macro}${CALLED}void mainImage(out vec4 c, in vec2 p) ${body}\n`;
  });
  return [...codes, ...SPELLED].map((code, i) => ({ code, i }));
}

/** What is written for a plain `main` draws what the pass draws, or the pass is kept. */
async function rewrittenPicture(context, codes) {
  for (const { code, i } of codes) {
    const file = put(`plain${i}.glsl`, code);
    shaderport(file, '--main', 'rewrite', '-o', path.join(work, `plain${i}.frag`), '--force');
    const ours = await open(context, port(file, `plain${i}`), '#size=64x36&paused');
    const theirs = await open(context, port(path.join(work, `plain${i}.frag`), `whole${i}`), '#size=64x36&paused');
    const drawn = await frame(ours.page, 3);
    assert.ok(colors(drawn) > 1, code);
    assert.equal(differences(drawn, await frame(theirs.page, 3)), 0, code);
    await Promise.all([ours.page.close(), theirs.page.close()]);
  }
}

/** The tests of the templates, and of the exports where there are any. */
export function corpusTests() {
  const shaders = fs.readdirSync(templates).filter((f) => f.endsWith('.glsl')).map((f) => path.join(templates, f));
  const tests = shaders.map((file) => ({
    name: `template: ${path.basename(file)}`,
    run: (context) => template(context, file),
  }));
  tests.push({ name: 'rewritten: the templates compile', run: (context) => rewritten(context, shaders) });
  const codes = rewrittenCodes();
  for (let i = 0; i < codes.length; i += 8) {
    const some = codes.slice(i, i + 8);
    tests.push({ name: `rewritten: the picture stays, from ${i} on`, run: (context) => rewrittenPicture(context, some) });
  }
  const cases = process.env.SHADERLINT_CASES && path.join(process.env.SHADERLINT_CASES, 'shadertoy');
  if (cases && fs.existsSync(cases)) {
    const every = Number(process.env.EVERY ?? 1);
    const all = fs.readdirSync(cases).filter((f) => f.endsWith('.json')).map((f) => path.join(cases, f));
    const exports = all.filter((_, i) => i % every === 0);
    count = exports.length;
    for (const file of exports) {
      const name = path.basename(file, '.json');
      tests.push({ name: `export: ${name}`, run: (context) => exported(context, file, name), onLate: () => slow.push(name) });
    }
    for (let i = 0; i < exports.length; i += 40) {
      const some = exports.slice(i, i + 40);
      tests.push({ name: `rewritten: exports from ${i} on`, run: (context) => rewritten(context, some), seconds: 240 });
    }
    tests.push({ name: 'exports: few are too slow to be drawn', run: fewAreSlow, isLast: true });
    tests.push({ name: 'exports: those that use the time move', run: mostMove, isLast: true });
  }
  return tests;
}

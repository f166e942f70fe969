// Shaders with a plain `main`, written by `--main rewrite`: they compile and draw the same as their
// passes.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { colors, differences, folder, put, shaderport } from './browser.js';
import { compileShaders } from './compiled.js';
import { compiledExports, templates } from './corpus.js';
import { draw } from './drawing.js';

/** Compiles every shader that `--main rewrite` considers safe. */
async function rewritten(context, files) {
  const texts = [];
  for (const file of files) {
    const out = path.join(folder(), path.parse(file).name);
    await shaderport(file, '-t', 'glsl', '--main', 'rewrite', '-o', out, '--force');
    const shaders = fs.statSync(out).isDirectory() ? fs.readdirSync(out).map((f) => path.join(out, f)) : [out];
    const written = shaders.map((f) => fs.readFileSync(f, 'utf8')).filter((t) => /\nvoid main\(\)/.test(t) && !t.includes('in vec2 pos'));
    texts.push(...written.map((fragment) => ({ name: path.basename(file), fragment })));
  }
  assert.ok(texts.length > 0);
  assert.deepEqual(await compileShaders(context, texts), []);
}

/** Bodies of `mainImage` with various obstacles to a plain `main`. */
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

/** Complete shaders in which `mainImage` is declared, called or spelled differently. */
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

/** The passes that are written with a plain `main`, numbered. */
function rewrittenCodes() {
  const codes = BODIES.map((body) => {
    const macro = body.includes('a,') && !body.includes('{\n#define a') ? '#define a 0.5\n' : '';
    return `${macro}${CALLED}void mainImage(out vec4 c, in vec2 p) ${body}\n`;
  });
  return [...codes, ...SPELLED].map((code, i) => ({ code, i }));
}

/** A plain `main` draws the same as the pass, or the pass is left unchanged. */
async function rewrittenPicture(context) {
  const both = [];
  for (const { code, i } of rewrittenCodes()) {
    const file = put(`plain${i}.glsl`, code);
    for (const how of ['wrap', 'rewrite']) {
      const out = path.join(folder(), `${how}${i}.frag`);
      await shaderport(file, '-t', 'glsl', '--main', how, '-o', out, '--force');
      both.push({ source: fs.readFileSync(out, 'utf8'), code });
    }
  }
  const page = await context.newPage();
  const drawn = await draw(page, both.map((one) => one.source), { iResolution: [64, 36, 1] });
  for (let i = 0; i < both.length; i += 2) {
    assert.ok(drawn[i] && drawn[i + 1], `compile error: ${both[i].code}`);
    assert.ok(colors(drawn[i]) > 1, both[i].code);
    assert.equal(differences(drawn[i], drawn[i + 1]), 0, both[i].code);
  }
}

export function rewriteTests() {
  const tests = [
    { name: 'rewritten: the templates compile', run: (context) => rewritten(context, templates()) },
    { name: 'rewritten: the image is the same', run: rewrittenPicture },
  ];
  const exports = compiledExports();
  if (exports.length > 0) tests.push({ name: 'rewritten: the exports compile', run: (context) => rewritten(context, exports) });
  return tests;
}

// Code changed by `shaderlint --fix` draws the same as before: verified by the browser, independently
// of the engine that made the fix.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { differences, folder, program, run } from './browser.js';
import { draw } from './drawing.js';
import { files } from './recorded.js';

const HEAD = '#version 300 es\nprecision highp float;\nuniform vec3 u;\nuniform ivec2 n;\nout vec4 color;\n';

/** Shaders to which a safe fix applies, each in a way that could go wrong. */
const CASES = [
  ['constructors', `
float hash(vec2 p) { vec3 q = fract(vec3(p.xyx) * 0.1031); q += dot(q, q.yzx + float(19.19)); return fract(float(q.x + q.y) * q.z); }
void main() { vec2 p = vec2(gl_FragCoord.xy) / 16.0; color = vec4(vec4(hash(p), float(-p.x), -float(p.y - 1.0), 1.0)); }`],
  ['constructors next to operators', `
void main() { float a = u.x, b = gl_FragCoord.x; color = vec4(float(a - b) * 0.1, 2.0 / float(a + b), float(b > 3.0 ? a : b) * 0.5, a - float(a - b)); }`],
  ['constructors of integers', `
void main() { int k = int(gl_FragCoord.x); color = vec4(float(int(k + n.x) % 5), float(int(k) / 2 * 2), uint(uint(k) >> 1) > 2u, 1.0) / 7.0; }`],
  ['constructors in macros', `
#define TWICE(x) float(x) * 2.0
#define SUM(a, b) vec2(a + b)
void main() { vec2 p = gl_FragCoord.xy / 40.0; color = vec4(TWICE(p.x + u.y), SUM(p, p.yx) * 0.5, float(p.y)); }`],
  ['self-assignments', `
float calls = 0.0;
int next() { calls += 0.125; return int(calls * 8.0) % 2; }
void main() { vec2 v = gl_FragCoord.xy / 64.0; v.x = v.x; v = v; float w[2]; w[0] = v.x; w[1] = v.y; w[0] = w[0];
  w[next()] = w[next()]; v.xy = v.yx; for (int i = 0; i < 3; i = i) { i++; v = v; } color = vec4(v, w[1], calls); }`],
  ['redundant comparisons of bools', `
bool far(vec2 p) { return length(p) > 20.0 ? true : false; }
void main() { vec2 p = gl_FragCoord.xy; bool b = p.x > 30.0 == false, c = far(p) == true || b == false;
  color = vec4(b && c == false ? 1.0 : 0.0, (c ? false : true) == b, far(p.yx) != true, 1.0); }`],
  ['unused suppressions', `
// shaderlint: allow(zero-division)
void main() { vec2 v = gl_FragCoord.xy; // shaderlint: allow(float-equality)
  color = vec4(v / u.xy, v.x == 3.5, 1.0); }`],
];

/** The fixed texts, by name. */
async function fixed(texts) {
  const place = (id) => path.join(folder(), `${id}.frag`);
  for (const { id, source } of texts) fs.writeFileSync(place(id), source);
  await run(program('shaderlint'), '--fix', '--select', 'all', '--no-config', '-q', folder());
  return texts.map(({ id }) => fs.readFileSync(place(id), 'utf8'));
}

/** Asserts that changed shaders draw the same as before; returns how many were changed and drawn. */
async function compare(context, texts) {
  const after = await fixed(texts);
  const changed = texts.map((text, i) => ({ ...text, after: after[i] })).filter((t) => t.after !== t.source);
  const page = await context.newPage();
  const drawn = await draw(page, changed.flatMap((t) => [t.source, t.after]));
  const pairs = changed.map((t, i) => ({ ...t, old: drawn[2 * i], now: drawn[2 * i + 1] }));
  const alone = pairs.filter((p) => p.old);
  const wrong = alone.filter((p) => !p.now || differences(p.old, p.now) > 0);
  assert.deepEqual(wrong.map((p) => `${p.id}:\n${p.after}`), []);
  return alone.length;
}

async function casesStay(context) {
  const texts = CASES.map(([, body], i) => ({ id: `case${i}`, source: HEAD + body.trimStart() }));
  assert.equal(await compare(context, texts), CASES.length, 'every case has a fix');
}

/** The small shaders of corpus/verdicts that the browser accepts. */
async function recordedStay(context) {
  const cases = files().flatMap((f) => f.cases).filter((c) => c.stage === 'fragment' && c.source.startsWith('#version 300 es'));
  await compare(context, cases.map(({ source }, i) => ({ id: `recorded${i}`, source })));
}

export const fixTests = [
  { name: 'fixes: safe fixes draw the same', run: casesStay },
  { name: 'fixes: small shaders draw the same', run: recordedStay },
];

// shaderlint's verdict is Chromium's: over the small shaders of tests/verdicts.txt, and over programs
// that fuzz/ writes.
//
//   node verdicts.js [COUNT] [SEED]   asks COUNT programs from SEED on, and prints where the two differ
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, top } from './browser.js';

/** Shaders that one page compiles at once. */
const BATCH = 200;

/** Compiles shaders until the compiler dies of one; gives whether each is accepted. */
function compile(page, shaders) {
  return page.evaluate((all) => {
    const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
    const accepted = [];
    for (const { stage, source } of all) {
      const shader = gl.createShader(stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      const ok = gl.getShaderParameter(shader, gl.COMPILE_STATUS) === true;
      // A compiler that died says nothing, to all that comes behind as well.
      if (!ok && !gl.getShaderInfoLog(shader)) break;
      accepted.push(ok);
      gl.deleteShader(shader);
    }
    return accepted;
  }, shaders);
}

/** The shaders of which the browser says otherwise. One on which its compiler dies has no verdict. */
async function disagreements(context, shaders) {
  const wrong = [];
  for (let at = 0; at < shaders.length; ) {
    const page = await context.newPage();
    const batch = shaders.slice(at, at + BATCH);
    const accepted = await compile(page, batch);
    accepted.forEach((ok, i) => {
      if (ok !== batch[i].ok) wrong.push(batch[i]);
    });
    if (accepted.length < batch.length) console.log(`no verdict: ${batch[accepted.length].id}`);
    at += accepted.length + (accepted.length < batch.length ? 1 : 0);
    await page.close();
  }
  return wrong;
}

/** The shader that a line of tests/verdicts.txt stands for. */
function small(line) {
  const [, rule, kind, code] = line.match(/^([^:]+): (\S+) (.*)$/);
  const [globals, body] = code.split('@@');
  const isFragment = kind.includes('f');
  const isNew = kind.startsWith('3');
  const source = [
    isNew ? '#version 300 es\n' : '',
    isFragment ? 'precision highp float;\n' : '',
    isFragment && isNew && !kind.includes('O') ? 'out vec4 o;\n' : '',
    `${globals.trim()}\n`,
    body === undefined ? '' : `void main(){${body}}\n`,
  ].join('');
  return { id: line, stage: isFragment ? 'fragment' : 'vertex', source, ok: rule === 'ok' };
}

function smallShaders() {
  const text = fs.readFileSync(path.join(top, 'tests/verdicts.txt'), 'utf8');
  return text.split('\n').filter((l) => l !== '' && !l.startsWith('#')).map(small);
}

/** Programs of `count` seeds, with shaderlint's verdict. */
function programs(count, seed) {
  const args = ['run', '--quiet', '-p', 'shaderlint-fuzz', '--', 'write', '--count', `${count}`, '--seed', `${seed}`];
  const text = execFileSync('cargo', args, { cwd: top, maxBuffer: 1 << 30 }).toString();
  return text.trim().split('\n').map((line) => JSON.parse(line));
}

async function agree(context, shaders) {
  const wrong = await disagreements(context, shaders);
  assert.deepEqual(wrong.map((s) => `${s.id}: ${s.ok ? 'refused' : 'accepted'} by the browser`), []);
}

export const verdictTests = [
  { name: 'verdicts of small shaders', run: (context) => agree(context, smallShaders()) },
  { name: 'verdicts of programs', seconds: 600, run: (context) => agree(context, programs(300, 1)) },
];

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [count, seed] = process.argv.slice(2).map(Number);
  const running = await launch();
  const context = await running.browser.newContext();
  const wrong = await disagreements(context, programs(count || 1000, seed || 1));
  for (const { id, ok, source } of wrong) {
    console.log(`--- seed ${id}: ${ok ? 'refused' : 'accepted'} by the browser alone\n${source}`);
  }
  console.log(`${count || 1000} programs, ${wrong.length} verdicts differ`);
  await running.kill();
  process.exit(wrong.length > 0 ? 1 : 0);
}

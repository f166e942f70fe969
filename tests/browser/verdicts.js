// shaderlint's verdict is Chromium's: over the small shaders of corpus/verdicts, where tests/verdicts.rs
// holds it to what is recorded, and over programs that fuzz/ writes.
//
//   node verdicts.js ask              records what the browser says of corpus/verdicts
//   node verdicts.js [COUNT] [SEED]   asks COUNT programs from SEED on, and prints where the two differ
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { fileURLToPath } from 'node:url';
import { launch } from './browser.js';
import { fuzzer } from './fuzzer.js';
import { files, head } from './recorded.js';

/** Shaders that one page compiles at once. */
const BATCH = 200;

/** Compiles shaders until the compiler dies of one; gives whether each is accepted, and the line of the first error. */
function compile(page, shaders) {
  return page.evaluate((all) => {
    const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
    const said = [];
    for (const { stage, source } of all) {
      const shader = gl.createShader(stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      const ok = gl.getShaderParameter(shader, gl.COMPILE_STATUS) === true;
      const log = gl.getShaderInfoLog(shader) ?? '';
      // A compiler that died says nothing, to all that comes behind as well.
      if (!ok && !log) break;
      said.push({ ok, line: Number(log.match(/ERROR: \d+:(\d+)/)?.[1] ?? 0), log });
      gl.deleteShader(shader);
    }
    return said;
  }, shaders);
}

/** What the browser says of each shader. One on which its compiler dies has no verdict. */
async function ask(context, shaders) {
  const said = [];
  for (let at = 0; at < shaders.length; at = said.length) {
    const page = await context.newPage();
    const batch = shaders.slice(at, at + BATCH);
    said.push(...(await compile(page, batch)));
    if (said.length < at + batch.length) {
      console.log(`no verdict: ${shaders[said.length].id}`);
      said.push(null);
    }
    await page.close();
  }
  return said;
}

/** The shaders of which the browser says otherwise. */
async function disagreements(context, shaders) {
  const said = await ask(context, shaders);
  return shaders.filter((s, i) => said[i] && said[i].ok !== s.ok);
}

/** Programs of `count` seeds, with shaderlint's verdict. */
const programs = (count, seed) => fuzzer('write', '--count', `${count}`, '--seed', `${seed}`);

async function agree(context, shaders) {
  const wrong = await disagreements(context, shaders);
  assert.deepEqual(wrong.map((s) => `${s.id}: ${s.ok ? 'refused' : 'accepted'} by the browser`), []);
}

/** What is recorded is what the browser says: verdict and line. */
async function isRecorded(context) {
  const cases = files().flatMap((f) => f.cases.map((one) => ({ ...one, head: f.lines[one.at] })));
  assert.ok(cases.length >= 300, `${cases.length} cases`);
  const said = await ask(context, cases);
  const wrong = cases.flatMap((one, i) => {
    const now = said[i] ? head(one, said[i]) : one.head;
    return now === one.head ? [] : [`${one.id}: ${one.head}\n  is now ${now}`];
  });
  assert.deepEqual(wrong, []);
}

/** Writes what the browser says into the heads of corpus/verdicts; names those that changed. */
async function record(context) {
  for (const { path, lines, cases } of files()) {
    const said = await ask(context, cases);
    cases.forEach((one, i) => {
      if (!said[i]) return;
      const now = head(one, said[i]);
      if (now === lines[one.at]) return;
      console.log(`${one.id}\n  ${lines[one.at]}\n  ${now}\n  ${said[i].log.split('\n')[0]}`);
      lines[one.at] = now;
    });
    fs.writeFileSync(path, lines.join('\n'));
  }
}

export const verdictTests = (seed) => [
  { name: 'verdicts of small shaders', run: isRecorded },
  { name: 'verdicts of programs', run: async (context) => agree(context, await programs(300, seed)) },
];

/** Asks for programs, and prints those that are judged otherwise; gives how many there are. */
async function compare(context, count, seed) {
  const wrong = await disagreements(context, await programs(count, seed));
  for (const { id, ok, source } of wrong) {
    console.log(`--- seed ${id}: ${ok ? 'refused' : 'accepted'} by the browser alone\n${source}`);
  }
  console.log(`${count} programs, ${wrong.length} verdicts differ`);
  return wrong.length;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const running = await launch();
  const context = await running.browser.newContext();
  const [first, seed] = process.argv.slice(2);
  const wrong = first === 'ask' ? await record(context) : await compare(context, Number(first) || 1000, Number(seed) || 1);
  await running.kill();
  process.exit(wrong ? 1 : 0);
}

// Every test in a real browser. Prints a line a test and a count; exits with 1 where one fails.
//
//   node all.js [WORD...]   only the tests whose names hold one of the words
import { rmSync } from 'node:fs';
import { launch, work } from './browser.js';
import { corpusTests } from './corpus.js';
import { hostileTests } from './hostile.js';
import { moduleTests } from './modules.js';
import { pageTests } from './page.js';
import { pixelTests } from './pixels.js';

const words = process.argv.slice(2);
const tests = [...pixelTests, ...pageTests, ...hostileTests, ...moduleTests, ...corpusTests()];
const wanted = tests.filter((t) => words.length === 0 || words.some((w) => t.name.includes(w)));

/** The browser, started again where it has gone. */
let starting = launch();
async function living() {
  const browser = await starting;
  if (browser.isConnected()) return browser;
  starting = launch();
  return starting;
}

/** Runs one test in a context of its own; gives what went wrong. */
async function run(test) {
  const browser = await living();
  const context = await browser.newContext({
    viewport: { width: 480, height: 320 },
    acceptDownloads: true,
    permissions: ['camera', 'microphone'],
    ...test.context,
  });
  context.setDefaultTimeout((test.seconds ?? 60) * 1000);
  let timer;
  const late = new Promise((_, reject) => {
    const seconds = test.seconds ?? 60;
    timer = setTimeout(() => reject(new Error(`took more than ${seconds} s`)), seconds * 1000);
  });
  try {
    await Promise.race([test.run(context), late]);
    return null;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  } finally {
    clearTimeout(timer);
    await context.close().catch(() => {});
  }
}

const started = Date.now();
const queue = wanted.filter((t) => !t.isLast);
let failures = 0;

async function worker() {
  for (let test = queue.shift(); test; test = queue.shift()) {
    const since = Date.now();
    let wrong = await run(test);
    // A browser that dies takes the test beside it along.
    if (wrong && !(await starting).isConnected()) wrong = await run(test);
    if (wrong) failures++;
    const ms = `${Date.now() - since} ms`;
    console.log(wrong ? `FAILED ${test.name} (${ms})\n       ${wrong.replace(/\n/g, '\n       ')}` : `ok     ${test.name} (${ms})`);
  }
}

await Promise.all([worker(), worker()]);
queue.push(...wanted.filter((t) => t.isLast));
await worker();
await (await starting).close();
rmSync(work, { recursive: true, force: true });
const seconds = ((Date.now() - started) / 1000).toFixed(0);
console.log(`${wanted.length} tests, ${failures} failed, ${seconds} s`);
process.exit(failures > 0 || wanted.length === 0 ? 1 : 0);

// Every test in a real browser. Prints a line a test and a count; exits with 1 where one fails.
//
//   node all.js [WORD...]   only the tests whose names hold one of the words
import { rmSync } from 'node:fs';
import { launch, work } from './browser.js';
import { corpusTests } from './corpus.js';
import { dialectTests } from './dialects.js';
import { drawnTests } from './drawn.js';
import { fixTests } from './fixes.js';
import { hostileTests } from './hostile.js';
import { mediaTests } from './media.js';
import { moduleTests } from './modules.js';
import { pageTests } from './page.js';
import { pixelTests } from './pixels.js';
import { serveTests } from './serve.js';
import { unitTests } from './units.js';
import { verdictTests } from './verdicts.js';
import { webgpuTests } from './webgpu.js';

const words = process.argv.slice(2);
const tests = [
  ...unitTests,
  ...pixelTests,
  ...mediaTests,
  ...pageTests,
  ...dialectTests,
  ...hostileTests,
  ...fixTests,
  ...moduleTests,
  ...serveTests,
  ...verdictTests,
  ...drawnTests,
  ...corpusTests(),
  ...webgpuTests(),
];
const wanted = tests.filter((t) => words.length === 0 || words.some((w) => t.name.includes(w)));

/** Seconds that a test may take which does not say so itself: many times what it takes on an idle machine. */
const PATIENCE = 180;

class Late extends Error {}

/** Gives what a promise gives, unless that takes too long. */
async function within(seconds, promise) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Late(`took more than ${seconds} s`)), seconds * 1000);
  });
  try {
    return await Promise.race([promise, late]);
  } finally {
    clearTimeout(timer);
  }
}

/** Runs one test in a context of its own. */
async function attempt(browser, test) {
  const context = await browser.newContext({
    viewport: { width: 480, height: 320 },
    acceptDownloads: true,
    permissions: ['camera', 'microphone'],
    ...test.context,
  });
  // What is waited for in vain is told by the test, not by its end; but for one that may come late.
  context.setDefaultTimeout((test.onLate ? 2000 : 900) * (test.seconds ?? PATIENCE));
  await test.run(context);
  await context.close();
}

const started = Date.now();
const queue = wanted.filter((t) => !t.isLast);
let failures = 0;

/** Says what came of a test. */
function tell(test, since, wrong) {
  const ms = `${Date.now() - since} ms`;
  if (!wrong) return console.log(`ok     ${test.name} (${ms})`);
  if (wrong instanceof Late && test.onLate) {
    test.onLate();
    return console.log(`late   ${test.name} (${ms})`);
  }
  failures++;
  return console.log(`FAILED ${test.name} (${ms})\n       ${wrong.message.replace(/\n/g, '\n       ')}`);
}

/** Runs tests as long as there are any, in a browser of its own. */
async function worker() {
  let running = await launch();
  for (let test = queue.shift(); test; test = queue.shift()) {
    const since = Date.now();
    let wrong = null;
    try {
      await within(test.seconds ?? PATIENCE, attempt(running.browser, test));
    } catch (error) {
      wrong = error instanceof Error ? error : new Error(String(error));
      // Whatever the test has left behind ends with its browser.
      await running.kill();
      running = await launch();
    }
    tell(test, since, wrong);
  }
  await running.kill();
}

await Promise.all([worker(), worker()]);
queue.push(...wanted.filter((t) => t.isLast));
await worker();
rmSync(work, { recursive: true, force: true });
const seconds = ((Date.now() - started) / 1000).toFixed(0);
console.log(`${wanted.length} tests, ${failures} failed, ${seconds} s`);
process.exit(failures > 0 || wanted.length === 0 ? 1 : 0);

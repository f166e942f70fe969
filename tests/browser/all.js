// The tests in a real browser. Prints a line a test and a count; exits with 1 where one fails.
//
//   node all.js [WORD...]   only the tests whose names hold one of the words, of all there are
//     --all                 every test; without it, those that are heavy or sweeps are left out
//     --list                prints the tests instead of running them
//     --seed N              where random programs begin; 1 without it
//     --minutes N           how long all of it may take
import { parseArgs } from 'node:util';
import { alone, launch } from './browser.js';
import { compileTests } from './compiled.js';
import { corpusTests } from './corpus.js';
import { dialectTests } from './dialects.js';
import { drawnTests } from './drawn.js';
import { fixTests } from './fixes.js';
import { hostileTests } from './hostile.js';
import { mediaTests } from './media.js';
import { moduleTests } from './modules.js';
import { pageTests } from './page.js';
import { pixelTests } from './pixels.js';
import { rewriteTests } from './rewritten.js';
import { serveTests } from './serve.js';
import { unitTests } from './units.js';
import { verdictTests } from './verdicts.js';
import { webgpuTests } from './webgpu.js';

const { values: options, positionals: words } = parseArgs({
  allowPositionals: true,
  options: {
    all: { type: 'boolean', default: false },
    list: { type: 'boolean', default: false },
    seed: { type: 'string', default: '1' },
    minutes: { type: 'string' },
  },
});
const seed = Number(options.seed);
const minutes = Number(options.minutes ?? (options.all ? 720 : 20));

/**
 * @typedef {object} Test
 * @property {string} name
 * @property {(context: import('playwright-core').BrowserContext) => Promise<void>} run
 * @property {object} [context] how its context differs from those of the others
 * @property {string} [only] why it is run with --all alone, or when it is asked for by a word
 * @property {boolean} [isLast] whether it counts what the others have found
 */

/** @type {Test[]} */
const tests = [
  ...compileTests(),
  ...drawnTests(seed),
  ...verdictTests(seed),
  ...mediaTests,
  ...(await webgpuTests()),
  ...(await corpusTests()),
  ...rewriteTests(),
  ...moduleTests,
  ...serveTests,
  ...pageTests,
  ...dialectTests,
  ...fixTests,
  ...hostileTests,
  ...pixelTests,
  ...unitTests,
];
const isWanted = (test) => (words.length > 0 ? words.some((w) => test.name.includes(w)) : options.all || !test.only);
const wanted = tests.filter(isWanted);

if (options.list) {
  for (const { name, only } of wanted.length < tests.length && words.length > 0 ? wanted : tests) {
    console.log(only ? `--all    ${name} (${only})` : `default  ${name}`);
  }
  process.exit(0);
}

/** @typedef {{browser: import('playwright-core').Browser, kill: () => Promise<void>}} Running */

/** What is running: tests with what their pages complained of, and browsers. */
const now = { tests: /** @type {Map<string, string[]>} */ (new Map()), browsers: /** @type {Set<Running>} */ (new Set()), isOver: false };

/** A browser that is ended when time is up. */
async function start() {
  const running = await launch();
  now.browsers.add(running);
  return running;
}

/** @param {Running} running */
async function stop(running) {
  now.browsers.delete(running);
  await running.kill();
}

/** Runs one test in a context and a folder of its own. @param {Running} running @param {Test} test */
async function attempt({ browser }, test) {
  const complaints = [];
  now.tests.set(test.name, complaints);
  const context = await browser.newContext({
    viewport: { width: 480, height: 320 },
    acceptDownloads: true,
    permissions: ['camera', 'microphone'],
    ...test.context,
  });
  // What is waited for has no limit of its own: a machine may be as slow as it is.
  context.setDefaultTimeout(0);
  await alone(complaints, () => test.run(context));
  if (browser.isConnected()) await context.close();
}

const started = Date.now();
const queue = wanted.filter((t) => !t.isLast);
let failures = 0;

/** Says what came of a test. */
function tell(test, since, wrong) {
  const ms = `${Date.now() - since} ms`;
  if (!wrong) return console.log(`ok     ${test.name} (${ms})`);
  failures++;
  const words = [...(now.isOver ? ['it was still running when time was up'] : []), wrong.stack, ...(now.tests.get(test.name) ?? [])];
  return console.log(`FAILED ${test.name} (${ms})\n       ${words.join('\n').replace(/\n/g, '\n       ')}`);
}

/** Runs tests as long as there are any, in a browser of its own. */
async function worker() {
  let running = await start();
  for (let test = queue.shift(); test; test = queue.shift()) {
    const since = Date.now();
    let wrong = null;
    try {
      await attempt(running, test);
    } catch (error) {
      wrong = error instanceof Error ? error : new Error(String(error));
    }
    tell(test, since, wrong);
    now.tests.delete(test.name);
    // Whatever a test has left behind that failed ends with its browser; some end it themselves.
    if ((wrong || !running.browser.isConnected()) && !now.isOver) {
      await stop(running);
      running = await start();
    }
  }
  await stop(running);
}

/** Ends everything, and says what was running: where it waits is in what fails then. */
async function timeIsUp() {
  now.isOver = true;
  console.log(`more than ${minutes} minutes; not ended: ${[...now.tests.keys()].join(', ')}; not begun: ${queue.length}`);
  queue.length = 0;
  await Promise.all([...now.browsers].map(stop));
  // The tests hear of it a little later; whatever has no part in a browser does not.
  await new Promise((resolve) => { setTimeout(resolve, 1000); });
  for (const [name, complaints] of now.tests) console.log(`FAILED ${name}`, ...complaints);
  process.exit(1);
}

console.log(`${wanted.length} of ${tests.length} tests, seed ${seed}`);
const limit = setTimeout(timeIsUp, minutes * 60_000);
await Promise.all([worker(), worker()]);
queue.push(...wanted.filter((t) => t.isLast));
if (queue.length > 0) await worker();
clearTimeout(limit);
const seconds = ((Date.now() - started) / 1000).toFixed(0);
console.log(`${wanted.length} tests, ${failures} failed, ${seconds} s`);
process.exit(failures > 0 || wanted.length === 0 ? 1 : 0);

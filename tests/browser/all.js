// Tests in a real browser. Prints one line per test and a count; exits with code 1 if one fails.
//
//   node all.js [WORD...]   only the tests whose names contain one of the words, out of all tests
//     --all                 every test; by default heavy tests and sweeps are skipped
//     --list                lists the tests instead of running them
//     --seed N              first seed of random programs; default 1
//     --minutes N           time limit for all tests
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
import { remountTests } from './remounted.js';
import { rewriteTests } from './rewritten.js';
import { serveTests } from './serve.js';
import { threeWebgpuTests } from './three_webgpu.js';
import { unitTests } from './units.js';
import { verdictTests } from './verdicts.js';
import { hasWgsl, webgpuTests } from './webgpu.js';

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
 * @property {object} [context] options of its browser context
 * @property {string} [only] why it runs only with --all or if a word selects it
 * @property {boolean} [isLast] whether it evaluates results of the other tests
 */

/** @type {Test[]} */
const tests = [
  ...compileTests(),
  ...drawnTests(seed),
  ...verdictTests(seed),
  ...mediaTests,
  ...(await webgpuTests()),
  ...((await hasWgsl()) ? threeWebgpuTests : []),
  ...(await corpusTests()),
  ...rewriteTests(),
  ...moduleTests,
  ...remountTests,
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

/** Running tests with the complaints of their pages, and running browsers. */
const now = { tests: /** @type {Map<string, string[]>} */ (new Map()), browsers: /** @type {Set<Running>} */ (new Set()), isOver: false };

/** Starts a browser that is killed when the time is up. */
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

/** Runs one test in its own context and folder. @param {Running} running @param {Test} test */
async function attempt({ browser }, test) {
  const complaints = [];
  now.tests.set(test.name, complaints);
  const context = await browser.newContext({
    viewport: { width: 480, height: 320 },
    acceptDownloads: true,
    permissions: ['camera', 'microphone'],
    ...test.context,
  });
  // Waits have no timeout of their own: machines may be slow.
  context.setDefaultTimeout(0);
  await alone(complaints, () => test.run(context));
  if (browser.isConnected()) await context.close();
}

const started = Date.now();
const queue = wanted.filter((t) => !t.isLast);
let failures = 0;

/** Prints the result of a test. */
function tell(test, since, wrong) {
  const ms = `${Date.now() - since} ms`;
  if (!wrong) return console.log(`ok     ${test.name} (${ms})`);
  failures++;
  const words = [...(now.isOver ? ['still running when the time was up'] : []), wrong.stack, ...(now.tests.get(test.name) ?? [])];
  return console.log(`FAILED ${test.name} (${ms})\n       ${words.join('\n').replace(/\n/g, '\n       ')}`);
}

/** Runs tests from the queue in its own browser. */
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
    // The browser is replaced after a failed test, and some tests kill it themselves.
    if ((wrong || !running.browser.isConnected()) && !now.isOver) {
      await stop(running);
      running = await start();
    }
  }
  await stop(running);
}

/** Kills everything and prints the running tests; their pending waits fail and show where they were. */
async function timeIsUp() {
  now.isOver = true;
  console.log(`more than ${minutes} minutes; running: ${[...now.tests.keys()].join(', ')}; not started: ${queue.length}`);
  queue.length = 0;
  await Promise.all([...now.browsers].map(stop));
  // The tests notice it a little later; code that does not use a browser does not notice it.
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

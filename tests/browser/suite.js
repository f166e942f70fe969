// Runs tests in Chromium with `node:test`, two at a time, each in a browser that no other test uses
// meanwhile. Arguments of the command line:
//
//   WORD...       only the tests whose names contain a word, out of all tests
//   --all         every test; by default heavy tests and sweeps are skipped
//   --list        lists the tests instead of running them
//   --seed N      first seed of random programs; default 1
//   --minutes N   time limit for all tests; default 20, and 720 with --all
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { parseArgs } from 'node:util';
import { alone, launch } from './browser.js';

export const { values: options, positionals: words } = parseArgs({
  allowPositionals: true,
  options: {
    all: { type: 'boolean', default: false },
    list: { type: 'boolean', default: false },
    seed: { type: 'string', default: '1' },
    minutes: { type: 'string' },
  },
});
const timeout = 60_000 * Number(options.minutes ?? (options.all ? 720 : 20));

/**
 * @typedef {object} Test
 * @property {string} name
 * @property {(given: any, ...more: any[]) => unknown} run
 * @property {object} [context] options of its browser context
 * @property {string} [only] why it runs only with --all or if a word selects it
 * @property {boolean} [isLast] whether it evaluates results of the other tests
 * @property {boolean} [mayComplain] whether its pages may show errors in the console
 */

/** Browsers that no test uses, and all that run. */
const idle = [];
const running = new Set();

async function start() {
  const started = await launch();
  running.add(started);
  return started;
}

/**
 * Runs a test in its own folder; errors and warnings of its pages fail it. The browser is replaced if the test
 * fails or kills it.
 * @param {(browser: import('playwright-core').Browser) => unknown} run
 */
async function attempt(run, mayComplain) {
  const browser = idle.pop() ?? await start();
  try {
    await alone(() => run(browser.browser), mayComplain);
    if (browser.browser.isConnected()) idle.push(browser);
  } finally {
    if (!idle.includes(browser)) {
      running.delete(browser);
      await browser.kill();
    }
  }
}

/** Runs a test in its own context. @param {import('playwright-core').Browser} browser @param {Test} one */
async function inContext(browser, one) {
  const context = await browser.newContext({
    viewport: { width: 480, height: 320 },
    acceptDownloads: true,
    permissions: ['camera', 'microphone'],
    ...one.context,
  });
  // Waits have no timeout of their own: machines may be slow.
  context.setDefaultTimeout(0);
  await one.run(context);
  if (browser.isConnected()) await context.close();
}

/**
 * Declares the selected tests, or lists all. @param {Test[]} tests @param {(browser: any, one: Test) => unknown} [run]
 */
export function suite(name, tests, run = inContext) {
  const isNamed = (one) => words.some((word) => one.name.includes(word));
  const wanted = tests.filter((one) => (words.length > 0 ? isNamed(one) : options.all || options.list || !one.only));
  assert.ok(wanted.length > 0, `no test of ${tests.length} is selected`);
  if (options.list) {
    for (const one of wanted) console.log(one.only ? `--all    ${one.name} (${one.only})` : `default  ${one.name}`);
    return;
  }
  const declare = (some) => some.forEach((one) => test(one.name, () => attempt((browser) => run(browser, one), one.mayComplain)));
  describe(`${name}, seed ${options.seed}`, { concurrency: 2, timeout }, () => declare(wanted.filter((one) => !one.isLast)));
  describe('results of the other tests', { timeout }, () => declare(wanted.filter((one) => one.isLast)));
  after(() => Promise.all([...running].map((browser) => browser.kill())));
}

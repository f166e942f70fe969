// Tests of the built site. Prints one line per test and a count; exits with code 1 if one fails.
//
//   node all.js [WORD...]   only the tests whose names contain one of the words
import { launch } from '../browser/browser.js';
import { builtTests } from './built.js';
import { debugTests } from './debug.js';
import { inspectTests } from './inspect.js';
import { openingTests } from './opening.js';
import { pageTests } from './pages.js';
import { passTests } from './passes.js';
import { playgroundTests } from './playground.js';
import { folder } from './read.js';
import { serve } from './serve.js';

// Nothing waits for a clock. This limit ends a run that would wait forever.
const minutes = 15;
let running = 'start of the browser';
setTimeout(() => {
  console.log(`FAILED  ${running}: not finished after ${minutes} minutes`);
  process.exit(1);
}, minutes * 60_000).unref();

const words = process.argv.slice(2);
const all = [...builtTests, ...pageTests, ...playgroundTests, ...passTests, ...openingTests, ...inspectTests, ...debugTests];
const tests = words.length > 0 ? all.filter((test) => words.some((word) => test.name.includes(word))) : all;
const server = await serve(folder);
const { browser, kill } = await launch();
let failed = 0;
for (const { name, run } of tests) {
  running = name;
  try {
    await run(browser, server.address);
    console.log(`ok      ${name}`);
  } catch (error) {
    failed++;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
console.log(`${tests.length - failed} passed, ${failed} failed`);
await kill();
await server.end();
process.exit(failed > 0 || tests.length === 0 ? 1 : 0);

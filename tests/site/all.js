// All tests of the built site; ../browser/suite.js describes the arguments.
import { after } from 'node:test';
import { suite } from '../browser/suite.js';
import { builtTests } from './built.js';
import { debugTests } from './debug.js';
import { inspectTests } from './inspect.js';
import { openingTests } from './opening.js';
import { pageTests } from './pages.js';
import { passTests } from './passes.js';
import { playgroundTests } from './playground.js';
import { folder } from './read.js';
import { serve } from './serve.js';

const server = await serve(folder);
const tests = [...builtTests, ...pageTests, ...playgroundTests, ...passTests, ...openingTests, ...inspectTests, ...debugTests];
suite('site', tests, (browser, { run }) => run(browser, server.address));
after(server.end);

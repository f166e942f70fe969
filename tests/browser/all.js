// All tests of pages and modules in a real browser; suite.js describes the arguments.
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
import { options, suite } from './suite.js';
import { threeWebgpuTests } from './three_webgpu.js';
import { typeTests } from './types.js';
import { unitTests } from './units.js';
import { verdictTests } from './verdicts.js';
import { hasWgsl, webgpuTests } from './webgpu.js';

const seed = Number(options.seed);
suite('pages and modules', [
  ...compileTests(),
  ...drawnTests(seed),
  ...verdictTests(seed),
  ...mediaTests,
  ...(await webgpuTests()),
  ...((await hasWgsl()) ? threeWebgpuTests : []),
  ...(await corpusTests()),
  ...rewriteTests(),
  ...moduleTests,
  ...typeTests,
  ...remountTests,
  ...serveTests,
  ...pageTests,
  ...dialectTests,
  ...fixTests,
  ...hostileTests,
  ...pixelTests,
  ...unitTests,
]);

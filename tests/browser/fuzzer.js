// The programs of fuzz/, of random numbers with a seed.
import path from 'node:path';
import { run, top } from './browser.js';

/** What the fuzzer prints, a line of JSON each; FUZZ names the program. @returns {Promise<any[]>} */
export async function fuzzer(...args) {
  const program = process.env.FUZZ || path.join(top, 'target/debug/shaderlint-fuzz');
  const { stdout } = await run(program, ...args);
  return stdout.trim().split('\n').map((line) => JSON.parse(line));
}

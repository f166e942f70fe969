// The random programs of fuzz/, determined by a seed.
import path from 'node:path';
import { run, top } from './browser.js';

/** The output of the fuzzer, one JSON value per line; FUZZ is the path of the program. @returns {Promise<any[]>} */
export async function fuzzer(...args) {
  const program = process.env.FUZZ || path.join(top, 'target/debug/shaderlint-fuzz');
  const { stdout } = await run(program, ...args);
  return stdout.trim().split('\n').map((line) => JSON.parse(line));
}

// Chromium draws what `shaderlint` computes: programs with exactly known results, bit for bit, and
// built-in functions of random numbers, within the bounds of the conformance suite.
//
//   node drawn.js [COUNT] [SEED]   draws COUNT programs starting at SEED, and prints those that differ
//
// If SwiftShader knows the value of a vector at compile time, it computes some functions incorrectly:
// with `bvec3 b = bvec3(false);`, `not(b)` is false, and `uvec2(1u) / (u | 1u)` is 0 if `u` is zero. A
// program that differs is drawn again with such values hidden; if it then agrees, the error is
// SwiftShader's.
import assert from 'node:assert/strict';
import { fileURLToPath } from 'node:url';
import { bytesOf, launch } from './browser.js';
import { fuzzer } from './fuzzer.js';

/** Number of programs that are drawn together. */
const BATCH = 25;

/**
 * @typedef {{id: string | number, source: string, seeds: number[], parts: number[], why?: string,
 *   pixels: number[][], bound?: string, by?: number}} Program
 */

// Runs inside the page, so it must not use anything from outside.
/** Draws programs into unsigned integer targets; returns the pixels, or the reason for a failure. */
function draw({ programs, size }) {
  const gl = new OffscreenCanvas(size, size).getContext('webgl2');
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, size, size);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const texture = gl.getParameter(gl.TEXTURE_BINDING_2D);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.viewport(0, 0, size, size);
  const compile = (type, source) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    return shader;
  };
  const corners = 'vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0, 1)';
  const triangle = compile(gl.VERTEX_SHADER, `#version 300 es\nvoid main() { gl_Position = ${corners}; }`);
  return programs.map(({ source, seeds, parts }) => {
    const program = gl.createProgram();
    const fragment = compile(gl.FRAGMENT_SHADER, source);
    gl.attachShader(program, triangle);
    gl.attachShader(program, fragment);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return { refused: gl.getShaderInfoLog(fragment) };
    gl.useProgram(program);
    gl.uniform4iv(gl.getUniformLocation(program, 'seeds'), seeds);
    gl.uniform4fv(gl.getUniformLocation(program, 'parts'), parts);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = new Uint32Array(size * size * 4);
    gl.readPixels(0, 0, size, size, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixels);
    gl.deleteProgram(program);
    gl.deleteShader(fragment);
    return { pixels: new Uint8Array(pixels.buffer).toBase64() };
  });
}

/** The programs of the fuzzer, and what `shaderlint` draws for them. @returns {Promise<Program[]>} */
const written = (...args) => fuzzer(...args);

const float = (() => {
  const bits = new Uint32Array(1);
  const number = new Float32Array(bits.buffer);
  return (x) => {
    bits[0] = x;
    return number[0];
  };
})();

/** The distance of a float to the next larger one. */
const unit = (x) => 2 ** Math.max(Math.floor(Math.log2(Math.abs(x) || 1e-38)) - 23, -149);

/** The maximum difference of a result from another implementation. */
const BOUNDS = {
  units: ({ mine, by }) => by * unit(mine),
  absolute: ({ by }) => by,
  power: ({ mine, a }) => (4 + 2 * Math.abs(a)) * unit(mine),
  logarithm: ({ mine }) => Math.max(4 * unit(mine), 2 ** -21),
  'power of any': ({ mine, a, b }) => {
    const power = Math.abs(b * Math.log2(a));
    return (8 + 4 * power) * unit(mine) + Math.abs(mine * b) * 2 ** -20;
  },
};

/** Whether a pixel of a built-in function is within its bound. */
function isWithin({ bound, by }, mine, theirs) {
  if (bound === undefined || bound === 'exact') return mine.every((x, i) => x === theirs[i]);
  const [a, b] = [float(mine[1]), float(mine[2])];
  const [x, y] = [float(mine[0]), float(theirs[0])];
  return Math.abs(x - y) <= BOUNDS[bound]({ mine: x, a, b, by });
}

/** The programs that are drawn differently, with the first differing pixel. */
async function otherwise(context, programs, size) {
  const wrong = programs.filter((p) => p.why).map((p) => ({ ...p, what: p.why }));
  const fit = programs.filter((p) => !p.why);
  for (let at = 0; at < fit.length; at += BATCH) {
    const batch = fit.slice(at, at + BATCH);
    const page = await context.newPage();
    const sent = batch.map(({ source, seeds, parts }) => ({ source, seeds, parts }));
    const drawn = await page.evaluate(draw, { programs: sent, size });
    await page.close();
    batch.forEach((program, i) => {
      const { refused, pixels } = drawn[i];
      if (!pixels) return wrong.push({ ...program, what: `refused: ${refused}` });
      const all = new Uint32Array(Uint8Array.from(bytesOf(pixels)).buffer);
      const theirs = (n) => [...all.subarray(4 * n, 4 * n + 4)];
      const bad = program.pixels.findIndex((mine, n) => !isWithin(program, mine, theirs(n)));
      if (bad >= 0) wrong.push({ ...program, what: `pixel ${bad}: ${program.pixels[bad]}, in the browser ${theirs(bad)}` });
    });
  }
  return wrong;
}

/**
 * The same program with variables that the compiler cannot evaluate.
 * @param {Program} program
 */
function hidden(program) {
  const never = `if (seeds.x == ${program.seeds[0] ^ 1})`;
  const declared = /^(const )?(bool|u?int|float|[biu]?vec[234])(?:\[(\d+)\])? (\w+) = .*;$/;
  const globals = [];
  let isInside = false;
  const lines = program.source.split('\n').map((line) => {
    if (/^\w.*\) \{$/.test(line) && !/^(if|for|while|switch)\b/.test(line)) isInside = true;
    const [, constant, type, array, name] = line.match(declared) ?? [];
    if (constant || !name) return line;
    const elements = Array(Number(array ?? 1)).fill(`${type}(1)`);
    const change = `${never} ${name} = ${array ? `${type}[](${elements.join()})` : elements[0]};`;
    if (isInside) return `${line} ${change}`;
    globals.push(change);
    return line;
  });
  const source = lines.join('\n').replace(/^void main\(\) \{$/m, `$&\n${globals.join('\n')}`);
  return { ...program, source };
}

async function agree(context, programs, size) {
  const wrong = await otherwise(context, programs, size);
  assert.deepEqual(wrong.map((p) => `${p.id}: ${p.what}`), []);
}

const programs = (count, seed) => written('drawn', '--count', `${count}`, '--seed', `${seed}`);

export const drawnTests = (seed) => [
  { name: 'drawn: built-in functions equal those of the browser', run: async (context) => agree(context, await written('builtins'), 64) },
  { name: 'drawn: random programs equal those of the browser', run: async (context) => agree(context, await programs(50, seed), 8) },
  { name: 'drawn: more random programs equal those of the browser', only: 'a sweep', run: async (context) => agree(context, await programs(250, seed + 50), 8) },
];

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const running = await launch();
  const context = await running.browser.newContext();
  const [count, seed] = process.argv.slice(2).map(Number);
  const differing = await otherwise(context, await programs(count || 1000, seed || 1), 8);
  const wrong = await otherwise(context, differing.map(hidden), 8);
  for (const { id } of differing) if (!wrong.some((w) => w.id === id)) console.log(`seed ${id}: constant values`);
  for (const { id, what, source } of wrong) console.log(`--- seed ${id}: ${what}\n${source}`);
  const known = differing.length - wrong.length;
  console.log(`${count || 1000} programs, ${wrong.length} drawn differently, ${known} only with constant values`);
  await running.kill();
  process.exit(wrong.length ? 1 : 0);
}

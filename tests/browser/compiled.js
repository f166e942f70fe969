// Checks that the shaders of every page compile: templates, test cases of the player, media stand-ins,
// and the exports in SHADERLINT_CASES. Nothing is drawn; one page compiles many shaders in parallel.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { port, put } from './browser.js';
import { CASES } from './cases.js';
import { compiledExports, templates } from './corpus.js';
import { readers } from './media.js';
import { load } from './player.js';

/** Number of shaders that are compiled in one graphics context. */
const BATCH = 64;

const { passSource } = load(['draw/gl.js'], ['passSource']);

/**
 * A fragment shader to compile, or, with a vertex shader, a program to link.
 * @typedef {{name: string, fragment: string, vertex?: string}} Shaders
 */

/**
 * The shaders of a page: those of its passes and of its media stand-ins. The vertex shader that most
 * pages have is the program's own and is not linked each time.
 * @returns {Omit<Shaders, 'name'>[]}
 */
function shadersOf(html) {
  const [, json] = /<script type="application\/json" id="project">(.*?)<\/script>/s.exec(html);
  const project = JSON.parse(json);
  const own = project.passes.map((pass) => {
    const source = passSource(project, pass);
    if (pass.fragment) return { vertex: source, fragment: pass.fragment };
    return pass.vertex ? { vertex: pass.vertex, fragment: source } : { fragment: source };
  });
  return [...own, ...(project.media ?? []).map(({ text }) => ({ fragment: text }))];
}

// Runs inside the page, so it must not use anything from outside.
/** Compiles shaders and links programs; returns the error of each. */
function build(all) {
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  const compile = (type, text) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
  };
  const started = all.map(({ vertex, fragment }) => {
    const shaders = [compile(gl.FRAGMENT_SHADER, fragment)];
    if (vertex === undefined) return { shaders };
    shaders.push(compile(gl.VERTEX_SHADER, vertex));
    const program = gl.createProgram();
    shaders.forEach((shader) => gl.attachShader(program, shader));
    gl.linkProgram(program);
    return { shaders, program };
  });
  // Status is queried only after all have been started: the browser compiles several in parallel.
  const wrong = started.map(({ shaders, program }) => {
    const bad = shaders.filter((s) => !gl.getShaderParameter(s, gl.COMPILE_STATUS));
    if (bad.length > 0) return bad.map((s) => gl.getShaderInfoLog(s) || 'the compiler has crashed').join('\n');
    if (!program || gl.getProgramParameter(program, gl.LINK_STATUS)) return '';
    return gl.getProgramInfoLog(program) || 'linking failed';
  });
  gl.getExtension('WEBGL_lose_context').loseContext();
  return wrong;
}

/** Compiles shaders, each text once; resolves to the errors. @param {Shaders[]} shaders */
export async function compileShaders(context, shaders) {
  const known = new Map(shaders.map((one) => [`${one.vertex ?? ''}\0${one.fragment}`, one]));
  const all = [...known.values()];
  const wrong = [];
  for (let at = 0; at < all.length; at += BATCH) {
    const batch = all.slice(at, at + BATCH);
    const page = await context.newPage();
    const said = await page.evaluate(build, batch.map(({ vertex, fragment }) => ({ vertex, fragment })));
    said.forEach((words, i) => words && wrong.push(`${batch[i].name}: ${words}`));
    await page.close();
  }
  return wrong;
}

/** Asserts that all shaders of the pages compile. @param {{name: string, address: string}[]} pages */
export async function pagesCompile(context, pages) {
  const shaders = pages.flatMap(({ name, address }) => {
    const found = shadersOf(fs.readFileSync(address.slice('file://'.length), 'utf8'));
    assert.ok(found.length > 0, `${name} has no shader`);
    return found.map((one) => ({ name, ...one }));
  });
  assert.deepEqual(await compileShaders(context, shaders), []);
}

/** The pages of exports and shader files. */
async function ported(files) {
  const pages = [];
  for (const [i, file] of files.entries()) pages.push({ name: path.basename(file), address: await port(file, `page${i}`) });
  return pages;
}

async function ownCompile(context) {
  const toys = [...CASES.map((test) => test.shader), ...readers()];
  const files = toys.map((toy, i) => put(`case${i}.json`, JSON.stringify(toy)));
  await pagesCompile(context, await ported([...files, ...templates()]));
}

export function compileTests() {
  const tests = [{ name: 'compiled: templates, cases and all stand-ins compile', run: ownCompile }];
  const exports = compiledExports();
  if (exports.length > 0) tests.push({ name: 'compiled: the exports compile', run: async (context) => pagesCompile(context, await ported(exports)) });
  return tests;
}

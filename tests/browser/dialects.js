// Shaders of every dialect, as people of each community write them: `shaderport FILE -o x.html` gives a
// page that draws.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { colors, frame, open, top, work } from './browser.js';

const FOLDER = path.join(top, 'tests/fixtures/dialects');

/** What tells the dialect in what is said of a file; nothing where the text alone cannot tell it. */
const TOLD = {
  'glsl-sandbox': 'read as GLSL Sandbox',
  bonzomatic: 'read as Bonzomatic',
  kodelife: 'read as KodeLife',
  'book-of-shaders': 'read as The Book of Shaders',
  three: 'read as a ShaderMaterial of three.js',
  twigl: 'read as twigl',
  isf: 'read as ISF',
  'vscode-shader-toy': 'read as VS Code Shader Toy',
  vertexshaderart: 'read as VertexShaderArt',
  shadered: 'read as SHADERed',
  synthclipse: 'read as Synthclipse',
};

/** Ports a file; gives the page and what is said. */
function convert(file, name, ...args) {
  const program = process.env.SHADERPORT || path.join(top, 'target/release/shaderport');
  const out = path.join(work, `${name}.html`);
  const log = path.join(work, `${name}.log`);
  execFileSync(program, [file, '-o', out, '--force', ...args], { stdio: ['ignore', 'ignore', fs.openSync(log, 'w')] });
  return { address: `file://${out}`, said: fs.readFileSync(log, 'utf8') };
}

/** @param {string} dialect @param {string} file */
function drawTest(dialect, file) {
  const name = `dialect-${dialect}-${file}`;
  const run = async (context) => {
    const from = dialect === 'kodi' ? ['--from', 'kodi'] : [];
    const { address, said } = convert(path.join(FOLDER, dialect, file), name, ...from);
    // What looks like GLSL Sandbox in one mode of twigl is read as that, which is the same.
    const told = dialect === 'twigl' && file === 'classic.glsl' ? TOLD['glsl-sandbox'] : TOLD[dialect];
    assert.ok(said.includes(told ?? ''), said);
    const { page, complaints } = await open(context, address);
    await page.evaluate(() => globalThis.shaderport.ready);
    assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), []);
    assert.ok(colors(await frame(page, 3)) > 1, 'one colour');
    assert.deepEqual(complaints, []);
  };
  return { name, run };
}

/** A control changes the picture without compiling anything. */
async function controlsAreUniforms(context) {
  const { address } = convert(path.join(FOLDER, 'three/gradient.glsl'), 'dialect-control');
  const { page } = await open(context, address);
  await page.evaluate(() => globalThis.shaderport.ready);
  await frame(page, 1);
  const before = await frame(page, 1);
  const kinds = await page.evaluate(() => globalThis.shaderport.player.project.controls.map((c) => `${c.name} ${c.kind}`));
  assert.deepEqual(kinds, ['uColorA color', 'uColorB color']);
  await page.evaluate(() => {
    globalThis.shaderport.player.setControl('uColorA', [0, 0, 0]);
    globalThis.shaderport.player.setControl('uColorB', [0, 0, 0]);
  });
  assert.ok(colors(before) > 1);
  assert.equal(colors(await frame(page, 1)), 1);
}

/** The files of a dialect that are ported; folders in it, and vertex shaders of ISF, belong to them. */
const filesOf = (dialect) =>
  fs.readdirSync(path.join(FOLDER, dialect), { withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith('.vs'))
    .map((entry) => entry.name)
    .sort();

const files = fs.readdirSync(FOLDER).sort().flatMap((dialect) => filesOf(dialect).map((file) => [dialect, file]));

export const dialectTests = [
  ...files.map(([dialect, file]) => drawTest(dialect, file)),
  { name: 'dialect-controls', run: controlsAreUniforms },
];

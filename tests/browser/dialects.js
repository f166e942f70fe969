// Typical shaders of every dialect: `shaderport FILE -o x.html` must produce a page that draws.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { colors, folder, frame, open, shaderport, top } from './browser.js';
import { pagesCompile } from './compiled.js';

const FOLDER = path.join(top, 'tests/fixtures/dialects');
/** Folders that are one project, by dialect, relative to that folder. */
const PROJECTS = { xscreensaver: '../projects/xscreensaver' };

/** The note that names each recognised dialect; absent if the text alone does not identify it. */
const TOLD = {
  'glsl-sandbox': 'read as GLSL Sandbox',
  bonzomatic: 'read as Bonzomatic',
  kodelife: 'read as KodeLife',
  'book-of-shaders': 'read as The Book of Shaders',
  three: 'read as three.js ShaderMaterial',
  twigl: 'read as twigl',
  isf: 'read as ISF',
  'vscode-shader-toy': 'read as VS Code Shader Toy',
  vertexshaderart: 'read as VertexShaderArt',
  hyprland: 'read as Hyprland',
  ghostty: 'read as Ghostty',
  niri: 'read as niri',
  'gl-transitions': 'read as GL Transitions',
  flutter: 'read as Flutter',
  xscreensaver: 'read as XScreenSaver',
};

/** Converts a file; resolves to the page and the messages. */
async function convert(file, name, ...args) {
  const out = path.join(folder(), `${name}.html`);
  const { code, stderr } = await shaderport(file, '-o', out, '--force', ...args);
  assert.equal(code, 0, stderr);
  return { address: `file://${out}`, said: stderr };
}

/** Converts a shader of a dialect, which must be recognised; resolves to the page's address. */
async function portFile(dialect, file) {
  const from = dialect === 'kodi' ? ['--host', 'kodi'] : [];
  const { address, said } = await convert(path.join(FOLDER, PROJECTS[dialect] ? '' : dialect, file), `${dialect}-${path.basename(file)}`, ...from);
  // What looks like GLSL Sandbox in one mode of twigl is read as GLSL Sandbox, which is equivalent.
  const told = dialect === 'twigl' && file === 'classic.glsl' ? TOLD['glsl-sandbox'] : TOLD[dialect];
  assert.ok(said.includes(told ?? ''), said);
  return address;
}

async function drawn(context, dialect, file) {
  const { page } = await open(context, await portFile(dialect, file), '#size=64x36&paused');
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.deepEqual(await page.evaluate(() => globalThis.shaderport.errors), []);
  const isPlain = async () => colors(await frame(page, 3)) === 1;
  if (await isPlain()) {
    // Some shaders show more only on a larger canvas.
    await page.evaluate(() => globalThis.shaderport.player.resize(480, 272));
    assert.ok(!(await isPlain()), 'one colour');
  }
}

/** Every shader of every dialect is recognised and compiles. */
async function allCompile(context) {
  const pages = [];
  for (const [dialect, file] of files) pages.push({ name: `${dialect}/${file}`, address: await portFile(dialect, file) });
  assert.ok(pages.length > 80);
  await pagesCompile(context, pages);
}

/** A control changes the image without recompiling. */
async function controlsAreUniforms(context) {
  const { address } = await convert(path.join(FOLDER, 'three/gradient.glsl'), 'dialect-control');
  const { page } = await open(context, address, '#size=64x36&paused');
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

/** The converted files of a dialect; subfolders and vertex shaders of ISF belong to other files. */
const filesOf = (dialect) =>
  PROJECTS[dialect]
    ? [PROJECTS[dialect]]
    : fs.readdirSync(path.join(FOLDER, dialect), { withFileTypes: true })
      .filter((entry) => entry.isFile() && !entry.name.endsWith('.vs'))
      .map((entry) => entry.name)
      .sort();

const files = [...fs.readdirSync(FOLDER), ...Object.keys(PROJECTS)].sort().flatMap((dialect) => filesOf(dialect).map((file) => [dialect, file]));

/** The first shader of each dialect is always drawn. */
const isFirst = (dialect, file) => filesOf(dialect)[0] === file;

export const dialectTests = [
  { name: 'dialects: every shader compiles', run: allCompile },
  ...files.map(([dialect, file]) => ({
    name: `dialect-${dialect}-${path.basename(file)}`,
    only: isFirst(dialect, file) ? undefined : 'a sweep; compilation is always tested',
    run: (context) => drawn(context, dialect, file),
  })),
  { name: 'dialects: controls set uniforms', run: controlsAreUniforms },
];

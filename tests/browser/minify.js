// Minifies the player and the style of its pages: `node minify.js` writes src/port/player/min, which the converter
// contains; `--check` fails if a file there is stale.
import fs from 'node:fs';
import path from 'node:path';
import { transform } from 'esbuild';
import { minify } from 'terser';

const from = path.join(import.meta.dirname, '../../src/port/player');
const to = path.join(from, 'min');

/** Types only, or modules that users read. */
const KEPT = ['types.js', ...['frames', 'materials', 'react', 'three', 'webgpu'].map((name) => `modules/${name}.js`)];

/** Names that the converter writes. */
const RESERVED = ['PROJECT', 'mount', 'openPage', 'startFrame', 'receiveProject', 'followChanges'];

/** The scripts share one scope: a name of all of them gets the same short name in each. */
const nameCache = { vars: { props: {} } };
const options = () => ({ compress: { passes: 3 }, mangle: { toplevel: true, reserved: RESERVED }, nameCache, ecma: 2022 });

/** A function that two scripts define would silently replace the first one. */
function refuseTwins(scripts) {
  const all = scripts.flatMap((name) => [...read(name).matchAll(/^(?:export )?(?:async )?function\*? (\w+)/gm)].map((found) => found[1]));
  const twins = all.filter((name, i) => all.indexOf(name) !== i);
  if (twins.length > 0) throw new Error(`several scripts define ${twins.join(', ')}`);
}

/** Gives each name of the shared scope its short name. */
async function nameAll(scripts) {
  refuseTwins(scripts);
  const text = scripts.map((name) => read(name).replace(/^export default .*$/m, '').replace(/^export /m, ''));
  await minify(text.join('\n'), options());
}

const read = (name) => fs.readFileSync(path.join(from, name), 'utf8');

async function minified(name) {
  if (name.endsWith('.js')) return `${(await minify(read(name), options())).code}\n`;
  return (await transform(read(name), { minify: true, loader: 'css', charset: 'utf8' })).code;
}

/** The files below a folder, by relative path. */
function below(folder) {
  const all = fs.readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((name) => name.replaceAll(path.sep, '/'));
  return all.filter((name) => /\.(js|css)$/.test(name));
}

// The player before its pages, each by file name: names are shortened in this order.
const order = (name) => `${Number(name.startsWith('page/'))}${path.basename(name)}`;
const names = below(from).filter((name) => !name.startsWith('min/') && !KEPT.includes(name));
names.sort((a, b) => (order(a) < order(b) ? -1 : 1));
await nameAll(names.filter((name) => name.endsWith('.js')));
const made = new Map();
for (const name of names) made.set(name, await minified(name));
const isCheck = process.argv.includes('--check');
const known = fs.existsSync(to) ? below(to) : [];
const stale = [...made].filter(([name, text]) => !known.includes(name) || fs.readFileSync(path.join(to, name), 'utf8') !== text).map(([name]) => name);
const left = known.filter((name) => !made.has(name));
if (isCheck && stale.length + left.length > 0) {
  console.error(`src/port/player/min is stale: ${[...stale, ...left].join(', ')}; run \`node tests/browser/minify.js\``);
  process.exit(1);
}
if (!isCheck) {
  for (const name of stale) {
    fs.mkdirSync(path.dirname(path.join(to, name)), { recursive: true });
    fs.writeFileSync(path.join(to, name), made.get(name));
  }
  for (const name of left) fs.rmSync(path.join(to, name));
}

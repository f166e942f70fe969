// Writes the examples of the playground: shaders of the repository, and the code of the pages of rules and
// compile errors.
import fs from 'node:fs';
import path from 'node:path';

const top = path.join(import.meta.dirname, '../..');
const read = (file) => fs.readFileSync(path.join(top, file), 'utf8');
const names = (folder, extension) => fs.readdirSync(path.join(top, folder)).filter((name) => extension.test(name)).sort();

/** The shaders in a folder. */
function shaders(label, folder) {
  const files = names(folder, /\.(glsl|frag)$/);
  return { label, examples: files.map((file) => ({ name: file, file, text: read(`${folder}/${file}`) })) };
}

const KINDS = { bad: 'Reported', good: 'Not reported' };

/** The examples of a page: fences such as `glsl bad old.frag`. */
function page(folder, file) {
  const text = read(`${folder}/${file}`);
  const fences = [...text.matchAll(/^```(glsl|html) (bad|good)(?: (\S+))?\n([^]*?)^```$/gm)];
  const count = (kind) => fences.filter((fence) => fence[2] === kind).length;
  const seen = { bad: 0, good: 0 };
  const examples = fences.map(([, language, kind, name, code]) => {
    const number = ++seen[kind];
    return {
      name: count(kind) > 1 ? `${KINDS[kind]} ${number}` : KINDS[kind],
      file: name ?? `shader.${language}`,
      text: code,
    };
  });
  const label = file.slice(0, -3).replaceAll('_', '-');
  // The first paragraph after the line with the facts.
  const summary = text.split('\n\n')[2].replaceAll('`', '').replaceAll('\n', ' ');
  return { label, summary, examples };
}

const pages = (folder) => names(folder, /^(?!README).*\.md$/).map((file) => page(folder, file));

const groups = [
  shaders('Complete shaders', 'corpus/templates'),
  shaders('Pitfalls', 'corpus/pitfalls'),
  shaders('Mistakes', 'corpus/mistakes'),
  ...[...pages('rules'), ...pages('rules/errors')].sort((a, b) => (a.label < b.label ? -1 : 1)),
];
fs.mkdirSync(path.join(import.meta.dirname, 'public'), { recursive: true });
fs.writeFileSync(path.join(import.meta.dirname, 'public/examples.json'), JSON.stringify(groups.filter(({ examples }) => examples.length > 0)));

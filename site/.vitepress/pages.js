// The pages of the site: the file that each is made from, and its address. Files stay where they are in
// the repository. Each address is a folder, so that it works on any server without configuration.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));

export const read = (file) => fs.readFileSync(path.join(root, file), 'utf8');

const markdown = (folder) => fs.readdirSync(path.join(root, folder))
  .filter((name) => name.endsWith('.md') && name !== 'README.md')
  .map((name) => name.slice(0, -3))
  .sort();

const rules = markdown('rules');
const errors = markdown('rules/errors');
const hosts = markdown('rules/hosts');

/** The name of a rule, which its file spells with `_`. */
const ruleName = (file) => file.replaceAll('_', '-');

/** Address of each page by the file that it is made from, both without the leading `/`. */
export const addresses = new Map([
  ['site/pages/index.md', ''],
  ['site/pages/errors.md', 'errors/'],
  ['rules/README.md', 'rules/'],
  ['rules/hosts/README.md', 'hosts/'],
  ['editors/README.md', 'editors/'],
  ['editors/agents.md', 'editors/agents/'],
  ['editors/vscode/README.md', 'editors/vscode/'],
  ['src/README.md', 'architecture/'],
  ['benches/README.md', 'benchmarks/'],
  ['corpus/README.md', 'corpus/'],
  ['CONTRIBUTING.md', 'contributing/'],
  ['CHANGELOG.md', 'changelog/'],
  ...markdown('docs').map((name) => [`docs/${name}.md`, `docs/${name}/`]),
  ...rules.map((name) => [`rules/${name}.md`, `rules/${ruleName(name)}/`]),
  ...errors.map((name) => [`rules/errors/${name}.md`, `errors/${name}/`]),
  ...hosts.map((name) => [`rules/hosts/${name}.md`, `hosts/${name}/`]),
]);

/** Addresses of the pages of rules and compile errors by name. */
export const findings = new Map([
  ...rules.map((name) => [ruleName(name), `/rules/${ruleName(name)}/`]),
  ...errors.map((name) => [name, `/errors/${name}/`]),
]);

/** Patterns of Markdown files that are not pages. */
export const excluded = () => {
  const folders = fs.readdirSync(root, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  const used = new Set([...addresses.keys()].map((file) => file.split('/')[0]));
  return [
    ...folders.filter((folder) => !used.has(folder.name)).map((folder) => `${folder.name}/**`),
    'README.md',
    'site/!(pages)/**',
    // `**` alone would match the files of the folder above, too.
    'src/*/**/*',
    'benches/*/**/*',
    'corpus/*/**/*',
    'editors/!(vscode)/**/*',
    'editors/vscode/*/**/*',
    'editors/vscode/CHANGELOG.md',
  ];
};

/** The rows of the first table after a mark `<!-- NAME -->` or a heading, as lists of cells. */
function rows(file, mark) {
  const lines = read(file).split(mark)[1].trimStart().split('\n');
  const start = lines.findIndex((line) => line.startsWith('|'));
  const end = lines.findIndex((line, i) => i > start && !line.startsWith('|'));
  return lines.slice(start + 2, end < 0 ? undefined : end).map((line) => line.slice(2, -2).split(' | ').map((cell) => cell.trim()));
}

/** The text of a cell `[text](address)`. */
const linkText = (cell) => cell.slice(1, cell.indexOf(']'));

/** The rules as listed in their README. */
export const allRules = () => rows('rules/README.md', '<!-- rules -->').map(
  ([name, group, severity, preset, fix, summary]) => ({ name: linkText(name), group, severity, preset, fix: fix || 'none', summary }),
);

/** The compile errors as listed in the README of the rules, which has them in the order of the compiler. */
export const allErrors = () => rows('rules/README.md', '<!-- errors -->').map(
  ([name, summary]) => ({ name: linkText(name), summary }),
).sort((a, b) => (a.name < b.name ? -1 : 1));

/** The hosts as listed in their README. */
export const allHosts = () => rows('rules/hosts/README.md', '## All hosts').map(
  ([name, title]) => ({ name: linkText(name), title }),
);

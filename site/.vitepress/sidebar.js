// The sidebars. That of the documentation has the groups of the list in README.md.
import path from 'node:path';
import { addresses, allErrors, allHosts, allRules, read } from './pages.js';

/** A name in a list; `webgl2` is a group of rules. */
const capitalized = (text) => text[0].toUpperCase() + text.slice(1).replace('ebgl', 'ebGL');

/** Pages that the README has no link to, by the page before them. */
const MORE = {
  'docs/editors.md': [['Editor setup', 'editors/README.md'], ['VS Code', 'editors/vscode/README.md']],
  'docs/comparison.md': [['Benchmarks', 'benches/README.md']],
  'src/README.md': [['Corpus', 'corpus/README.md']],
};

const entry = (text, file) => ({ text: capitalized(text), link: `/${addresses.get(file)}` });

/** The entry of a link of the README, and those after it. */
function entries([, text, link]) {
  const file = path.normalize(link);
  return [entry(text, file), ...(MORE[file] ?? []).map(([more, other]) => entry(more, other))];
}

/** The groups of the list `- Group: [Title](file) · [Title](file)` of README.md. */
function documentation() {
  const list = read('README.md').split('## Documentation')[1].split('\n').filter((line) => line.startsWith('- '));
  return list.map((line) => ({
    text: line.slice(2, line.indexOf(':')),
    items: Array.from(line.matchAll(/\[([^\]]+)\]\(([^)]+)\)/g), entries).flat(),
  }));
}

function rules() {
  const all = allRules();
  const groups = [...new Set(all.map((rule) => rule.group))].sort();
  return [
    { text: 'All rules', link: '/rules/' },
    ...groups.map((group) => ({
      text: capitalized(group),
      collapsed: true,
      items: all.filter((rule) => rule.group === group).map(({ name }) => ({ text: name, link: `/rules/${name}/` })),
    })),
  ];
}

const errors = () => [
  { text: 'All compile errors', link: '/errors/' },
  { text: 'Errors', items: allErrors().map(({ name }) => ({ text: name, link: `/errors/${name}/` })) },
];

const hosts = () => [
  { text: 'All hosts', link: '/hosts/' },
  { text: 'Hosts', items: allHosts().map(({ name, title }) => ({ text: title, link: `/hosts/${name}/` })) },
];

export const sidebar = () => {
  const docs = documentation();
  const folders = ['docs', 'editors', 'architecture', 'contributing', 'changelog', 'benchmarks', 'corpus'];
  return {
    ...Object.fromEntries(folders.map((folder) => [`/${folder}/`, docs])),
    '/rules/': rules(),
    '/errors/': errors(),
    '/hosts/': hosts(),
  };
};

// The sidebars. That of the documentation has the groups of the list in README.md.
import path from 'node:path';
import { addresses, allErrors, allHosts, allRules, read } from './pages.js';

const capitalized = (text) => text[0].toUpperCase() + text.slice(1).replace('ebgl', 'ebGL');

/** The groups of the list `- Group: [Title](file) · [Title](file)` of README.md. */
function documentation() {
  const list = read('README.md').split('## Documentation')[1].split('\n').filter((line) => line.startsWith('- '));
  return list.map((line) => ({
    text: line.slice(2, line.indexOf(':')),
    items: [...line.matchAll(/\[([^\]]+)\]\(([^)]+)\)/g)].map(([, text, file]) => ({ text: capitalized(text), link: `/${addresses.get(path.normalize(file))}` })),
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

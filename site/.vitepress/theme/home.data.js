// The finding on the first page: the one in README.md, which a test compares with what is printed.
import { playground } from '../playground.js';
import { read } from '../pages.js';
import { terminal } from '../markdown/terminal.js';

export default {
  watch: ['../../../README.md'],
  load() {
    const printed = read('README.md').split('```console\n')[1].split('\n```')[0];
    const file = /^\$ shaderlint (\S+)/.exec(printed)[1];
    return { finding: terminal(printed), address: playground(read(file)) };
  },
};

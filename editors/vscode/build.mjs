// Bundles the extension into a folder, and writes the licences of its dependencies beside it: `extension.js` for
// Node, and `browser.js` with its worker.
import { build } from 'esbuild';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';

const out = process.argv[2] ?? 'dist';
const common = {
    bundle: true,
    external: ['vscode'],
    format: 'cjs',
    legalComments: 'none',
    // The browser's part names its worker and module, so it never asks for its own address.
    logOverride: { 'empty-import-meta': 'silent' },
    metafile: true,
    minify: true,
};
// A module reads its own file only in Node.
const browser = { platform: 'browser', target: 'es2022', external: ['vscode', 'node:fs/promises'] };
const bundles = await Promise.all([
    build({ ...common, entryPoints: ['src/node.ts'], outfile: `${out}/extension.js`, platform: 'node', target: 'node18' }),
    build({ ...common, ...browser, entryPoints: ['src/browser.ts'], outfile: `${out}/browser.js` }),
    build({ ...common, ...browser, entryPoints: ['../../src/wasm/js/worker.js'], outfile: `${out}/worker.js`, format: 'iife' }),
]);

const folders = new Set(
    bundles.flatMap(({ metafile }) => Object.keys(metafile.inputs))
        .map((file) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0])
        .filter((folder) => folder !== undefined),
);
const notices = [...folders].sort().map((folder) => {
    const { name, version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    if (!file) throw new Error(`${name} has no licence`);
    return `${name} ${version}\n\n${readFileSync(`${folder}/${file}`, 'utf8').trim()}\n`;
});
writeFileSync(`${out}/licenses.txt`, notices.join(`\n${'-'.repeat(79)}\n\n`));

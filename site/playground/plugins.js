// What the build adds to what Vite makes of the page.
import crypto from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';

const here = (file) => path.join(import.meta.dirname, file);
const hashOf = (...texts) => crypto.createHash('sha256').update(texts.join('\0')).digest('base64');

/** A page whose policy has more sources. */
const allowing = (html, directive, sources) => html.replace(`${directive} 'self'`, `${directive} 'self' ${sources}`);

/**
 * Allows the script and the style of the player, and no others: without a network its page is not loaded into
 * the frame but written into it, and then has the policy of this page beside its own.
 */
export const offlinePlayer = {
  name: 'offline player',
  transformIndexHtml: {
    order: 'pre',
    handler(html) {
      const player = fs.readFileSync(here('public/player.html'), 'utf8');
      const hashes = (directive) => new RegExp(`${directive} ('sha256-[^;]*);`).exec(player)[1];
      return ['script-src', 'style-src'].reduce((made, directive) => allowing(made, directive, hashes(directive)), html);
    },
  },
};

/** Writes the script that applies the theme into the page, and allows it there: nothing is shown before it ran. */
export const earlyScript = {
  name: 'early script',
  transformIndexHtml: {
    order: 'pre',
    handler(html) {
      const script = fs.readFileSync(here('src/early.js'), 'utf8').replace(/^\s*\/\/.*\n/gm, '').trim();
      const written = html.replace('<script src="./src/early.js"></script>', () => `<script>${script}</script>`);
      return allowing(written, 'script-src', `'sha256-${hashOf(script)}'`);
    },
  },
};

/** Loads the editor while the script before it starts the language server. */
export const preload = {
  name: 'preload',
  transformIndexHtml: {
    order: 'post',
    handler(_, { bundle }) {
      const chunks = Object.values(bundle ?? {});
      const editor = chunks.find(({ type, facadeModuleId }) => type === 'chunk' && facadeModuleId?.endsWith('/main.js'));
      return editor && [{ tag: 'link', attrs: { rel: 'modulepreload', href: `./${editor.fileName}` }, injectTo: 'head' }];
    },
  },
};

/** Files that are loaded only by some machines or for some tasks. The service worker keeps them once they were loaded. */
const isRare = (file) => /^assets\/shaderlint-plain-|^service-worker/.test(file);

/** Writes the service worker with the files of this build. */
export const serviceWorker = {
  name: 'service worker',
  enforce: 'post',
  generateBundle(_, bundle) {
    const others = fs.readdirSync(here('public'));
    const built = Object.keys(bundle).filter((file) => !isRare(file) && file !== 'index.html');
    const files = ['./', ...others, ...built].sort();
    const contents = [bundle['index.html'].source, ...others.map((file) => fs.readFileSync(here(`public/${file}`), 'utf8'))];
    const version = hashOf(...files, ...contents).replace(/\W/g, '').slice(0, 12);
    const source = `const VERSION = '${version}';\nconst FILES = ${JSON.stringify(files)};\n${fs.readFileSync(here('src/service-worker.js'), 'utf8')}`;
    this.emitFile({ type: 'asset', fileName: 'service-worker.js', source });
  },
};

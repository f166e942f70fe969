// The playground as static files that any server can serve from any folder.
import { defineConfig } from 'vite';
import { earlyScript, offlinePlayer, preload, serviceWorker } from './plugins.js';

export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    // The modules are loaded while the page starts, not as text inside a script.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // The editor and its protocol, all of which the first view needs: 170 kB compressed.
    chunkSizeWarningLimit: 600,
  },
  worker: { format: 'es' },
  plugins: [earlyScript, offlinePlayer, preload, serviceWorker],
});

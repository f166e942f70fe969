// Starts the language server while the editor is still being loaded: nothing else takes as long.
import { startServer } from '../wasm/server.js';

/** The language server; the page says so if it cannot start. */
export const server = startServer();
server.catch(() => {});

import('./main.js');

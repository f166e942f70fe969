// A server for the built site that does what any server of static files does, and nothing else.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const TYPES = {
  '.css': 'text/css', '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.png': 'image/png',
  '.svg': 'image/svg+xml', '.txt': 'text/plain', '.wasm': 'application/wasm', '.xml': 'application/xml',
};

/** Serves a folder; resolves to its address and a function that stops the server. */
export async function serve(folder) {
  const server = http.createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://page.test');
    let file = path.join(folder, decodeURIComponent(pathname));
    const isFolder = fs.existsSync(file) && fs.statSync(file).isDirectory();
    if (isFolder && !pathname.endsWith('/')) {
      response.writeHead(301, { Location: `${pathname}/` }).end();
      return;
    }
    if (isFolder) file = path.join(file, 'index.html');
    const found = fs.existsSync(file);
    if (!found) file = path.join(folder, '404.html');
    response.writeHead(found ? 200 : 404, { 'Content-Type': TYPES[path.extname(file)] ?? 'application/octet-stream' });
    response.end(fs.readFileSync(file));
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    address: `http://127.0.0.1:${port}/`,
    end: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }),
  };
}

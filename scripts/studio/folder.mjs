// A plain file server: it knows folders, files and media types, and nothing of the service.

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const TYPES = {
  '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
};

/** Serves a folder on a free port: { url, seen, stop }. `seen` has the paths that were asked for. */
export async function startFolder(folder) {
  const seen = [];
  const server = createServer(async ({ method, url }, response) => {
    const { pathname } = new URL(url, 'http://localhost');
    seen.push(pathname);
    const file = join(folder, normalize(pathname.endsWith('/') ? `${pathname}index.html` : pathname));
    const bytes = method === 'GET' ? await readFile(file).catch(() => null) : null;
    response.writeHead(bytes ? 200 : method === 'GET' ? 404 : 405, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
    response.end(bytes ?? '');
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  return {
    url: `http://127.0.0.1:${server.address().port}`, seen,
    stop: () => new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    }),
  };
}

// A real server for the tests: PLATEAU_BIN, or the debug build of the checkout with the feature `test-hooks`.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { Hold } from './hold.mjs';

const binary = process.env.PLATEAU_BIN ?? fileURLToPath(new URL('../../../target/debug/plateau', import.meta.url));

/** Starts a server on a free port: { url, hold, stop }. */
export async function startServer() {
  const folder = await mkdtemp(join(tmpdir(), 'plateau-client-'));
  const hold = new Hold(join(folder, 'hold'));
  const env = { ...process.env, ...hold.environment };
  const server = spawn(binary, ['--listen', '127.0.0.1:0', '--data', folder], { stdio: ['ignore', 'pipe', 'pipe'], env });
  let log = '';
  server.stderr.on('data', (text) => (log += text));
  const [line] = await once(createInterface({ input: server.stdout }), 'line');
  const [, url] = /^listening on (\S+)/.exec(line) ?? [];
  assert.ok(url, line);
  const stop = async () => {
    server.kill();
    await once(server, 'exit');
    await rm(folder, { recursive: true, force: true, maxRetries: 5 });
    assert.ok(!log.includes('panic'), log);
  };
  return { url, hold, stop };
}

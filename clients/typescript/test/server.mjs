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

/**
 * Starts a server on a free port: { url, hold, kill, restart, stop }. `restart` starts it again after `kill`, on the same
 * data and where it was. `settings` are variables of its environment.
 */
export async function startServer(settings = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'plateau-client-'));
  const hold = new Hold(join(folder, 'hold'));
  const env = { ...process.env, ...settings, ...hold.environment };
  let log = '';
  let server;
  const start = async (address) => {
    const process = spawn(binary, ['--listen', address, '--data', folder], { stdio: ['ignore', 'pipe', 'pipe'], env });
    server = process;
    process.stderr.on('data', (text) => (log += text));
    const [line] = await once(createInterface({ input: process.stdout }), 'line');
    const [, found] = /^listening on (\S+)/.exec(line) ?? [];
    assert.ok(found, line);
    return found;
  };
  const url = await start('127.0.0.1:0');
  const end = async (signal) => {
    if (server.exitCode !== null || server.signalCode !== null) return; // ended by `kill` and not started again
    server.kill(signal);
    await once(server, 'exit');
  };
  const stop = async () => {
    await end('SIGTERM');
    await rm(folder, { recursive: true, force: true, maxRetries: 5 });
    assert.ok(!log.includes('panic'), log);
  };
  return { url, hold, kill: () => end('SIGKILL'), restart: () => start(new URL(url).host), stop };
}

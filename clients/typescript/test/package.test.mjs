// The package itself: generated types, a tarball in a fresh folder, the README's code, a browser.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { cp, mkdir, mkdtemp, readFile, readdir, rm, symlink, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { build } from 'esbuild';
import { version } from 'plateau-client';
import { isSkipped } from '../../../scripts/skips.mjs';
import { startServer } from './server.mjs';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const CHECKOUT = fileURLToPath(new URL('../../..', import.meta.url));
const TSC = join(ROOT, 'node_modules/typescript/bin/tsc');

/** Runs a program; its output is in the error if it fails. */
async function run(command, ...rest) {
  const options = typeof rest.at(-1) === 'object' ? rest.pop() : {};
  try {
    return (await promisify(execFile)(command, rest, { cwd: ROOT, ...options })).stdout;
  } catch (error) {
    throw new Error(`${command} ${rest.join(' ')}\n${error.stdout}${error.stderr}`);
  }
}

let server;
before(async () => (server = await startServer()));
after(() => server.stop());

test('the types are those of the API document', async () => {
  await run(process.execPath, 'generate.mjs', '--check');
});

test('a fresh folder installs the package; the code of its pages compiles strictly and runs there', async (context) => {
  const folder = await mkdtemp(join(tmpdir(), 'plateau-package-'));
  context.after(() => rm(folder, { recursive: true, force: true }));
  const inFolder = { cwd: folder, env: { ...process.env, PLATEAU_URL: server.url } };
  await writeFile(join(folder, 'package.json'), '{ "type": "module" }');
  // The README's own commands.
  const own = await readFile(join(ROOT, 'README.md'), 'utf8');
  const [, options] = /^npm pack (.*)\.\.\/plateau\/clients\/typescript$/m.exec(own);
  const [, packed] = /^npm install (\S+\.tgz)$/m.exec(own);
  const quiet = ['--no-audit', '--no-fund', '--omit=peer', '--ignore-scripts'];
  await run('npm', 'pack', '--ignore-scripts', ...options.split(' ').filter(Boolean), ROOT, inFolder);
  await run('npm', 'install', ...quiet, packed, inFolder);
  // A later installation of something else looks at every package again.
  await run('npm', 'install', ...quiet, inFolder);
  for (const name of ['LICENSE-MIT', 'LICENSE-APACHE']) {
    const [own, packed] = [join(CHECKOUT, name), join(folder, 'node_modules/plateau-client', name)];
    assert.equal(await readFile(packed, 'utf8'), await readFile(own, 'utf8'));
  }
  const manifest = JSON.parse(await readFile(join(ROOT, 'package.json'), 'utf8'));
  assert.equal(manifest.version, version);
  const workspace = await readFile(join(CHECKOUT, 'Cargo.toml'), 'utf8');
  // Both name the project's address, or neither does.
  assert.equal(manifest.repository?.url, /^repository = "(.*)"$/m.exec(workspace)?.[1]);
  const installed = await readdir(join(folder, 'node_modules'));
  assert.deepEqual(installed.filter((name) => !name.startsWith('.')), ['eventsource-parser', 'plateau-client']);

  const pages = [join(ROOT, 'README.md'), join(CHECKOUT, 'README.md'), join(CHECKOUT, 'docs/clients.md')];
  const text = (await Promise.all(pages.map((page) => readFile(page, 'utf8')))).join('\n');
  const blocks = [...text.matchAll(/```ts\n(.*?)```/gs)].map((match) => match[1]);
  for (const kind of ['ruledSurface', 'minimalSurface', 'uniformMesh', 'tensileStructure', 'cableNet']) {
    assert.ok(own.includes(`.${kind}(`), `the README has no program for ${kind}`);
  }
  for (const [index, block] of blocks.entries()) await writeFile(join(folder, `block${index}.ts`), `${block}\nexport {};\n`);

  // The first block runs with nothing else installed; the others may use three.js and the types of Node.js.
  const strict = ['--strict', '--target', 'es2022', '--module', 'nodenext', '--skipLibCheck', 'false'];
  await run(process.execPath, TSC, ...strict, '--lib', 'es2022,dom', 'block0.ts', inFolder);
  await run(process.execPath, 'block0.js', inFolder);
  await mkdir(join(folder, 'node_modules/@types'));
  // A page has its own three.js, and the package must use that one.
  await cp(join(ROOT, 'node_modules/three'), join(folder, 'node_modules/three'), { recursive: true });
  const contents = "export { Mesh } from 'three'; export { toBufferGeometry } from 'plateau-client/three';";
  const { metafile } = await build({ stdin: { contents, resolveDir: folder }, bundle: true, write: false, metafile: true });
  const copies = Object.keys(metafile.inputs).filter((path) => path.endsWith('node_modules/three/build/three.core.js'));
  assert.equal(copies.length, 1, copies.join(', '));
  await symlink(join(ROOT, 'node_modules/@types/three'), join(folder, 'node_modules/@types/three'));
  await cp(join(ROOT, 'test/node.d.ts'), join(folder, 'node.d.ts'));
  const others = blocks.slice(1).map((_, index) => `block${index + 1}.ts`);
  const lenient = [...strict.slice(0, -1), 'true', '--lib', 'es2022,dom'];
  await run(process.execPath, TSC, ...lenient, 'node.d.ts', ...others, inFolder);
  for (const name of others) await run(process.execPath, name.replace('.ts', '.js'), inFolder);
  assert.equal((await readFile(join(folder, 'strip.glb'))).subarray(0, 4).toString(), 'glTF');
});

const playwright = join(CHECKOUT, 'scripts/node_modules/playwright-core/index.mjs');
const chromium = process.env.CHROMIUM || ['/usr/bin/chromium', '/usr/bin/google-chrome'].find(existsSync);
const missing = existsSync(playwright) ? !chromium && 'no Chromium' : 'the browser driver of scripts/ is not installed';

test('a browser solves, follows progress and drags', async (t) => {
  if (isSkipped(t, 'TypeScript client in a browser', missing)) return;
  const contents = `export * from './dist/index.js'; export * from './dist/three.js';`;
  const bundle = await build({
    stdin: { contents, resolveDir: ROOT }, bundle: true, write: false, format: 'iife', globalName: 'client',
  });
  const driver = await import(playwright);
  const browser = await driver.chromium.launch({ executablePath: chromium, args: ['--no-sandbox'] });
  try {
    const page = await browser.newPage();
    await page.goto(server.url);
    await page.evaluate(`${bundle.outputFiles[0].text}; globalThis.client = client;`);
    const seen = await page.evaluate(async () => {
      const { Plateau, toBufferGeometry } = globalThis.client;
      const plateau = new Plateau({ url: location.origin });
      const ring = (height) => [[[0, 0, 0], [8, 0, height], [8, 8, 0], [0, 8, 3]]];
      const phases = [];
      const film = await plateau.minimalSurface(ring(3), {}, { onProgress: (progress) => phases.push(progress.phase) });
      const live = plateau.live();
      const drag = (height) => live.solve({ kind: 'minimal_surface', boundaries: ring(height) });
      const dragged = (await Promise.all([4, 5, 6].map(drag))).map((mesh) => mesh?.vertices[5] ?? null);
      const refused = await plateau.minimalSurface([[[0, 0, 0]]]).catch((error) => error.errors[0].pointer);
      const positions = toBufferGeometry(film).getAttribute('position').count;
      return { phases, vertices: film.vertices.length, positions, dragged, refused };
    });
    // A page of another origin, which the server's settings do not name.
    const other = createServer((_, response) => response.setHeader('Content-Type', 'text/html').end('<p>A page'));
    await once(other.listen(0, '127.0.0.1'), 'listening');
    await page.goto(`http://127.0.0.1:${other.address().port}`);
    await page.evaluate(`${bundle.outputFiles[0].text}; globalThis.client = client;`);
    const blocked = await page.evaluate((url) => new globalThis.client.Plateau({ url }).limits().catch(({ message }) => message), server.url);
    other.closeAllConnections();
    other.close();
    assert.match(blocked, /http\.cors_origins must name/);
    assert.equal(seen.phases.at(-1), 'finished');
    assert.equal(seen.vertices, 3 * seen.positions);
    assert.deepEqual(seen.dragged, [null, null, 6]);
    assert.equal(seen.refused, '/boundaries/0');
  } finally {
    await browser.close();
  }
});

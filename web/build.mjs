// Builds the studio: the bundle and the list of licences into dist/. With `--check` it leaves the
// committed files alone and fails if one differs from what it would write. The service's TypeScript
// client and plateau-page are bundled from their sources (`paths` of tsconfig.json), so that they
// need not be built or installed first.
//
// `--static FOLDER` then makes a studio in a folder that works without the service, from any file server.

import { build } from 'esbuild';
import { copyFile, mkdir, readFile, readdir, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const checking = process.argv.includes('--check');
const stale = [];

/** Writes a file of the web folder, or notes that the committed one differs. */
async function put(path, content) {
  const bytes = Buffer.from(content);
  const before = await readFile(join(here, path)).catch(() => null);
  if (before?.equals(bytes)) return;
  if (checking) stale.push(path);
  else await writeFile(join(here, path), bytes);
}

const common = {
  absWorkingDir: here, tsconfig: 'tsconfig.json', outdir: 'dist', write: false, metafile: true, bundle: true, minify: true,
  format: 'esm', target: 'es2022', charset: 'utf8', legalComments: 'none', external: ['*.woff2', '*.webp'],
};
// The names have no hash, because the service embeds each file by its name. `chunk.js` has what both `studio.js` and
// `later.js` need.
const bundled = await build({ ...common, entryPoints: { studio: 'src/main.ts' }, splitting: true, chunkNames: '[name]' });
const worker = await build({ ...common, entryPoints: { worker: '../crates/page/js/worker.mjs' } });
for (const { path, contents } of [...bundled.outputFiles, ...worker.outputFiles]) await put(path.slice(here.length + 1), contents);

for (const file of await readdir(join(here, 'static'))) await put(`dist/${file}`, await readFile(join(here, "static", file)));
// The page that other sites embed lies beside the files that it names, and says that it is embedded.
const page = await readFile(join(here, 'static/index.html'), 'utf8');
await put('dist/embed.html', page.replaceAll('"studio/', '"').replace('<html lang="en">', '<html lang="en" data-embed>'));
const font = 'node_modules/@fontsource-variable/inter';
await put('dist/inter.woff2', await readFile(join(here, font, 'files/inter-latin-wght-normal.woff2')));

// The licence of every package that is part of the bundle.
const packages = new Set([font]);
for (const input of Object.keys(bundled.metafile.inputs)) {
  const [, name] = /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input) ?? [];
  if (name) packages.add(`node_modules/${name}`);
}
let licences = 'The studio contains these packages:\n';
for (const folder of [...packages].sort()) {
  const { name, version, license } = JSON.parse(await readFile(join(here, folder, 'package.json'), 'utf8'));
  const file = (await readdir(join(here, folder))).find((each) => /^licen[cs]e/i.test(each));
  licences += `\n${'='.repeat(80)}\n${name} ${version} (${license})\n\n${file ? (await readFile(join(here, folder, file), 'utf8')).trim() : ''}\n`;
}
await put('dist/licences.txt', licences);

if (stale.length > 0) {
  console.error(`The committed bundle is not what its sources make. Run npm ci && npm run build in web/. Stale: ${stale.join(', ')}`);
  process.exit(1);
}

// ---- A studio without a service ----

const at = process.argv.indexOf('--static');
if (at >= 0) {
  const folder = resolve(process.argv[at + 1]);
  const data = join(folder, 'studio/data');
  await mkdir(join(data, 'examples'), { recursive: true });
  for (const file of await readdir(join(here, 'dist'))) if (!file.endsWith('.html')) await copyFile(join(here, 'dist', file), join(folder, 'studio', file));
  const modules = join(here, '../crates/page/js');
  for (const name of await readdir(modules)) if (name.endsWith('.wasm')) await copyFile(join(modules, name), join(folder, 'studio', name));
  for (const [name, content] of [['index.html', page], ['studio/embed.html', await readFile(join(here, 'dist/embed.html'), 'utf8')]]) {
    await writeFile(join(folder, name), content.replace('<html lang="en"', '<html lang="en" data-static'));
  }
  const api = join(here, '../api');
  for (const name of ['openapi.json', 'objectives.json', 'examples.json']) await copyFile(join(api, name), join(data, name));
  for (const { name, kind, title } of JSON.parse(await readFile(join(api, 'examples.json'), 'utf8')).examples) {
    const request = JSON.parse(await readFile(join(api, 'examples', `${name}.json`), 'utf8'));
    await writeFile(join(data, 'examples', `${name}.json`), JSON.stringify({ kind, title, request }));
  }
}

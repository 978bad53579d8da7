// Builds the studio: the bundle and the list of licences into dist/. With `--check` it leaves the
// committed files alone and fails if one differs from what it would write. The service's TypeScript
// client is bundled from its sources (`paths` of tsconfig.json), so that it need not be built or
// installed first.

import { build } from 'esbuild';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
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

const bundled = await build({
  absWorkingDir: here, tsconfig: 'tsconfig.json', entryPoints: { studio: 'src/main.ts' }, outdir: 'dist', write: false, metafile: true,
  bundle: true, minify: true, format: 'esm', target: 'es2022', charset: 'utf8', legalComments: 'none',
  external: ['*.woff2', '*.webp'],
});
for (const { path, contents } of bundled.outputFiles) await put(path.slice(here.length + 1), contents);

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

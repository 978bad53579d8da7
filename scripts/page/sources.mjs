// The sources that the committed modules were built from. `node scripts/page/sources.mjs FOLDER` writes their hash and the sizes of
// the modules to FOLDER/built.json.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';

export const root = fileURLToPath(new URL('../../', import.meta.url));
/** The crate `page`, and the crates of this project on which it depends. */
const CRATES = ['page'];
for (const name of CRATES) {
  const manifest = readFileSync(join(root, `crates/${name}/Cargo.toml`), 'utf8');
  const [, dependencies] = /^\[dependencies\]$([\s\S]*?)^\[/m.exec(manifest);
  for (const [, other] of dependencies.matchAll(/^plateau-([a-z-]+)/gm)) if (!CRATES.includes(other)) CRATES.push(other);
}
CRATES.sort();
const MODULES = ['shapes', 'structures'];
/** The files and folders of the sources, relative to the repository. */
export const SOURCES = ['Cargo.toml', 'Cargo.lock', 'scripts/build-page', ...CRATES.flatMap((name) => [`crates/${name}/Cargo.toml`, `crates/${name}/src`])];

function files(path) {
  const full = join(root, path);
  if (!existsSync(full)) return [];
  try {
    return readdirSync(full).sort().flatMap((name) => files(`${path}/${name}`));
  } catch {
    return [path];
  }
}

/** The SHA-256 of all sources with their names. Tests beside the sources are part of it. */
export function hashOfSources() {
  const hash = createHash('sha256');
  for (const path of SOURCES.flatMap(files)) hash.update(`${path}\n`).update(readFileSync(join(root, path))).update('\n');
  return hash.digest('hex');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folder = process.argv[2];
  const there = MODULES.filter((name) => existsSync(join(folder, `${name}.wasm`)));
  const modules = Object.fromEntries(there.map((name) => {
    const bytes = readFileSync(join(folder, `${name}.wasm`));
    return [name, { bytes: bytes.length, brotli: brotliCompressSync(bytes).length, sha256: createHash('sha256').update(bytes).digest('hex') }];
  }));
  const built = { sources: hashOfSources(), modules };
  writeFileSync(join(folder, 'built.json'), `${JSON.stringify(built, null, 1)}\n`);
  for (const [name, { bytes, brotli }] of Object.entries(modules)) console.log(`${name}.wasm: ${bytes} bytes, ${brotli} as Brotli`);
}

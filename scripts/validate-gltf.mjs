// Runs the Khronos validator on .glb and .gltf files, or on folders of them: node scripts/validate-gltf.mjs PATH...
// Fails on any error or warning, and prints infos and hints. Needs `npm ci` in scripts/.
import { readFile, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';
import validator from 'gltf-validator';

const isMesh = (name) => name.endsWith('.glb') || name.endsWith('.gltf');

async function filesUnder(path) {
  if (!(await stat(path)).isDirectory()) return [path];
  const names = await readdir(path, { recursive: true });
  return names.filter(isMesh).sort().map((name) => join(path, name));
}

const files = (await Promise.all(process.argv.slice(2).map(filesUnder))).flat();
let failed = 0;
for (const file of files) {
  const { issues } = await validator.validateBytes(new Uint8Array(await readFile(file)), { maxIssues: 20 });
  const bad = issues.numErrors + issues.numWarnings > 0 || issues.truncated;
  failed += bad ? 1 : 0;
  for (const { code, message, pointer } of issues.messages) console.log(`${file}: ${code} ${pointer}: ${message}`);
}
console.log(`${files.length - failed} passed, ${failed} failed`);
// A run without files fails, because it has checked nothing.
process.exitCode = failed > 0 || files.length === 0 ? 1 : 0;

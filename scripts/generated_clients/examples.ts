// The examples that each TypeScript program sends, and the check of an answer.
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';

export const url = process.env['PLATEAU_URL'] ?? '';
export const PATIENCE = 'wait=60';

const folder = `${process.cwd()}/api/examples`;

/**
 * Calls `solve` with the request of every example. It returns the statistics and the mesh as GLB. `written` returns the
 * JSON that the client sends for a request, which must be the content of the example's file.
 */
export async function run<Request>(
  program: string,
  example: (name: string) => Promise<Request>,
  solve: (request: Request) => Promise<{ statistics: { triangles: number; objective: string }; mesh: ArrayBuffer }>,
  written: (request: Request) => unknown = (request) => request,
): Promise<void> {
  const names = (await readdir(folder)).map((file) => file.replace('.json', '')).sort();
  let failed = 0;
  for (const name of names) {
    try {
      const request = await example(name);
      // JavaScript writes -0 as 0.
      const file = JSON.stringify(JSON.parse(await readFile(`${folder}/${name}.json`, 'utf8')));
      assert.deepEqual(JSON.parse(JSON.stringify(written(request))), JSON.parse(file));
      const { statistics, mesh } = await solve(request);
      // A cable net has no triangles.
      assert.ok((statistics.triangles > 0 || statistics.objective === 'nearest_to_targets') && statistics.objective.length > 0);
      assert.equal(new TextDecoder().decode(mesh.slice(0, 4)), 'glTF');
    } catch (error) {
      failed += 1;
      console.error(`${program}: ${name}:`, error);
    }
  }
  console.log(`${program}: ${names.length - failed} of ${names.length} examples`);
  process.exitCode = failed > 0 ? 1 : 0;
}

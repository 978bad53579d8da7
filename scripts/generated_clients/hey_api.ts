// Runs the client of @hey-api/openapi-ts over every example.
import { PATIENCE, run, url } from './examples';
import {
  getExample, getJob, getMesh, type Job, type MinimalSurfaceRequest, postCableNet, postMinimalSurface,
  postRuledSurface, postTensileStructure, postUniformMesh, type RequestWithKind,
} from './generated/hey_api';
import { client } from './generated/hey_api/client.gen';

client.setConfig({ baseUrl: url, throwOnError: true });
const headers = { Prefer: PATIENCE };
const options = { headers, throwOnError: true } as const;

// Nothing but the required fields is needed.
const least: MinimalSurfaceRequest = { boundaries: [[[0, 0, 0], [1, 0, 0], [0, 1, 1]]] };

function post(request: RequestWithKind) {
  switch (request.kind) {
    case 'ruled_surface': return postRuledSurface({ body: request, ...options });
    case 'minimal_surface': return postMinimalSurface({ body: request, ...options });
    case 'uniform_mesh': return postUniformMesh({ body: request, ...options });
    case 'tensile_structure': return postTensileStructure({ body: request, ...options });
    case 'cable_net': return postCableNet({ body: request, ...options });
  }
}

async function solve(request: RequestWithKind) {
  // The answer is a mesh only if the request accepts one.
  let job = (await post(request)).data as Job;
  while (job.status === 'queued' || job.status === 'running') {
    job = (await getJob({ path: { id: job.id }, ...options })).data;
  }
  // Each kind has its own statistics.
  if (job.kind === 'minimal_surface' && job.statistics && !(job.statistics.area > 0)) throw new Error('no area');
  if (job.kind === 'uniform_mesh' && job.statistics && !(job.statistics.nodes > 0)) throw new Error('no nodes');
  if (!job.statistics) throw new Error(JSON.stringify(job.error));
  // This client decides by the media type how to read an answer. It knows this one as bytes.
  const mesh = await getMesh({ path: { id: job.id }, headers: { Accept: 'application/octet-stream' }, throwOnError: true });
  return { statistics: job.statistics, mesh: await (mesh.data as Blob).arrayBuffer() };
}

await solve({ ...least, kind: 'minimal_surface' });
await run('@hey-api/openapi-ts', async (name) => (await getExample({ path: { name: name as 'tent' }, throwOnError: true })).data.request, solve);

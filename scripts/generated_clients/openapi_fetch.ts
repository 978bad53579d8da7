// Runs openapi-fetch with the types of openapi-typescript over every example.
import createClient from 'openapi-fetch';
import { PATIENCE, run, url } from './examples';
import type { components, paths } from './generated/openapi';

type Schemas = components['schemas'];
type Job = Schemas['Job'];
const client = createClient<paths>({ baseUrl: url });
const header = { Prefer: PATIENCE };

// Nothing but the required fields is needed.
const least: Schemas['MinimalSurfaceRequest'] = { boundaries: [[[0, 0, 0], [1, 0, 0], [0, 1, 1]]] };

const found = <T>(answer: { data?: T | undefined; error?: unknown }): T => {
  if (answer.data === undefined) throw new Error(JSON.stringify(answer.error));
  return answer.data;
};

function post(request: Schemas['RequestWithKind']) {
  switch (request.kind) {
    case 'ruled_surface': return client.POST('/v1/ruled-surfaces', { body: request, params: { header } });
    case 'minimal_surface': return client.POST('/v1/minimal-surfaces', { body: request, params: { header } });
    case 'uniform_mesh': return client.POST('/v1/uniform-meshes', { body: request, params: { header } });
    case 'tensile_structure': return client.POST('/v1/tensile-structures', { body: request, params: { header } });
    case 'cable_net': return client.POST('/v1/cable-nets', { body: request, params: { header } });
  }
}

async function solve(request: Schemas['RequestWithKind']) {
  // The answer is a mesh only if the request accepts one.
  let job = found<unknown>(await post(request)) as Job;
  while (job.status === 'queued' || job.status === 'running') {
    job = found<Job>(await client.GET('/v1/jobs/{id}', { params: { path: { id: job.id }, header } }));
  }
  // Each kind has its own statistics.
  if (job.kind === 'minimal_surface' && job.statistics && !(job.statistics.area > 0)) throw new Error('no area');
  if (job.kind === 'uniform_mesh' && job.statistics && !(job.statistics.nodes > 0)) throw new Error('no nodes');
  if (!job.statistics) throw new Error(JSON.stringify(job.error));
  const mesh = found(await client.GET('/v1/jobs/{id}/mesh', { params: { path: { id: job.id } }, parseAs: 'arrayBuffer' }));
  return { statistics: job.statistics, mesh };
}

await solve({ ...least, kind: 'minimal_surface' });
await run(
  'openapi-fetch',
  async (name) => found(await client.GET('/v1/examples/{name}', { params: { path: { name: name as 'tent' } } })).request,
  solve,
);

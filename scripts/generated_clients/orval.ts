// Runs the client of orval over every example.
import { PATIENCE, run } from './examples';
import {
  getExample, getJob, getMesh, type Job, postCableNet, postMinimalSurface, postRuledSurface, postTensileStructure,
  postUniformMesh, type RequestWithKind,
} from './generated/orval';

const options = { headers: { Prefer: PATIENCE } };

type Answer = { status: number; data: unknown };

/** Returns the data of an answer with one of these states, or throws the problem document. */
function data<A extends Answer>(answer: A): Extract<A, { status: 200 | 202 }>['data'] {
  if (answer.status !== 200 && answer.status !== 202) throw new Error(JSON.stringify(answer.data));
  return answer.data;
}

function post(request: RequestWithKind) {
  switch (request.kind) {
    case 'ruled_surface': return postRuledSurface(request, options);
    case 'minimal_surface': return postMinimalSurface(request, options);
    case 'uniform_mesh': return postUniformMesh(request, options);
    case 'tensile_structure': return postTensileStructure(request, options);
    case 'cable_net': return postCableNet(request, options);
  }
}

async function solve(request: RequestWithKind) {
  // The answer is a mesh only if the request accepts one.
  let job = data(await post(request)) as Job;
  while (job.status === 'queued' || job.status === 'running') job = data(await getJob(job.id, options));
  // Each kind has its own statistics.
  if (job.kind === 'minimal_surface' && job.statistics && !(job.statistics.area > 0)) throw new Error('no area');
  if (job.kind === 'uniform_mesh' && job.statistics && !(job.statistics.nodes > 0)) throw new Error('no nodes');
  if (!job.statistics) throw new Error(JSON.stringify(job.error));
  const mesh = await getMesh(job.id, { format: 'glb' });
  return { statistics: job.statistics, mesh: await (mesh.data as Blob).arrayBuffer() };
}

await run('orval', async (name) => data(await getExample(name as 'tent')).request, solve);

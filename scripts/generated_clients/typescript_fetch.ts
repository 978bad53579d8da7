// Runs the client of openapi-generator's typescript-fetch over every example.
import { PATIENCE, run, url } from './examples';
import {
  CatalogueApi, Configuration, JobsApi, type Job, type RequestWithKind, RequestWithKindToJSON, SolveApi,
} from './generated/typescript_fetch';

const configuration = new Configuration({ basePath: url });
const catalogue = new CatalogueApi(configuration);
const solving = new SolveApi(configuration);
const jobs = new JobsApi(configuration);

function post(request: RequestWithKind): Promise<{ id: string }> {
  const prefer = PATIENCE;
  switch (request.kind) {
    case 'ruled_surface': return solving.postRuledSurface({ ruledSurfaceRequest: request, prefer });
    case 'minimal_surface': return solving.postMinimalSurface({ minimalSurfaceRequest: request, prefer });
    case 'uniform_mesh': return solving.postUniformMesh({ uniformMeshRequest: request, prefer });
    case 'tensile_structure': return solving.postTensileStructure({ tensileStructureRequest: request, prefer });
    case 'cable_net': return solving.postCableNet({ cableNetRequest: request, prefer });
  }
}

async function solve(request: RequestWithKind) {
  const { id } = await post(request);
  let job: Job;
  do job = await jobs.getJob({ id, prefer: PATIENCE }); while (job.status === 'queued' || job.status === 'running');
  // Each kind has its own statistics.
  if (job.kind === 'minimal_surface' && job.statistics && !(job.statistics.area > 0)) throw new Error('no area');
  if (job.kind === 'uniform_mesh' && job.statistics && !(job.statistics.nodes > 0)) throw new Error('no nodes');
  if (!job.statistics) throw new Error(JSON.stringify(job.error));
  return { statistics: job.statistics, mesh: await (await jobs.getMesh({ id, format: 'glb' })).arrayBuffer() };
}

await run(
  'typescript-fetch',
  async (name) => (await catalogue.getExample({ name: name as 'tent' })).request,
  solve,
  RequestWithKindToJSON,
);

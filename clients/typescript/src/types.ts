/** Names for the types of the API document. */
import type { components, operations } from './openapi.js';

type Schemas = components['schemas'];

export type Kind = Schemas['Kind'];
export type Status = Schemas['Status'];
export type Units = Schemas['Units'];
export type UpAxis = Schemas['UpAxis'];
export type JobInfo = Schemas['Job'];
export type BatchInfo = Schemas['Batch'];
export type JobSummary = Schemas['JobSummary'];
export type JobWarning = Schemas['JobWarning'];
export type Progress = Schemas['Progress'];
export type Limits = Schemas['Limits'];
export type ObjectiveList = Schemas['ObjectiveList'];
export type Objective = ObjectiveList['objectives'][number];
export type FieldError = Schemas['FieldError'];
export type Problem = Schemas['Problem'];
export type ExampleSummary = Schemas['ExampleSummary'];
export type HistoryRow = Schemas['HistoryRow'];
export type RuledStatistics = Schemas['RuledStatistics'];
export type MinimalStatistics = Schemas['MinimalStatistics'];
export type UniformStatistics = Schemas['UniformStatistics'];
export type TensileStatistics = Schemas['TensileStatistics'];
export type TensileFilm = Schemas['TensileFilm'];
export type CableNetStatistics = Schemas['CableNetStatistics'];

export type RuledSurfaceOptions = Omit<Schemas['RuledSurfaceRequest'], 'kind' | 'directrices'>;
export type MinimalSurfaceOptions = Omit<Schemas['MinimalSurfaceRequest'], 'kind' | 'boundaries'>;
export type UniformMeshOptions = Omit<Schemas['UniformMeshRequest'], 'kind' | 'domain' | 'edge_length'>;
export type TensileStructureOptions = Omit<Schemas['TensileStructureRequest'], 'kind' | 'boundaries' | 'film' | 'layers'>;
export type CableNetOptions = Omit<Schemas['CableNetRequest'], 'kind' | 'vertices' | 'edges' | 'supports'>;

/** A request with its kind, as `GET /v1/examples` has them. */
export type Request =
  | (Omit<Schemas['RuledSurfaceRequest'], 'kind'> & { kind: 'ruled_surface' })
  | (Omit<Schemas['MinimalSurfaceRequest'], 'kind'> & { kind: 'minimal_surface' })
  | (Omit<Schemas['UniformMeshRequest'], 'kind'> & { kind: 'uniform_mesh' })
  | (Omit<Schemas['TensileStructureRequest'], 'kind'> & { kind: 'tensile_structure' })
  | (Omit<Schemas['CableNetRequest'], 'kind'> & { kind: 'cable_net' });

/** What the statistics of a request's mesh are. */
export type StatisticsOf<R extends { kind: Kind }> = R['kind'] extends 'ruled_surface'
  ? RuledStatistics
  : R['kind'] extends 'minimal_surface'
    ? MinimalStatistics
    : R['kind'] extends 'uniform_mesh'
      ? UniformStatistics
      : R['kind'] extends 'tensile_structure'
        ? TensileStatistics
        : R['kind'] extends 'cable_net'
          ? CableNetStatistics
          : RuledStatistics | MinimalStatistics | UniformStatistics | TensileStatistics | CableNetStatistics;

export type MeshFormat = 'glb' | 'gltf' | 'obj' | 'ply' | 'stl' | 'json';
export type PatternFormat = 'svg' | 'dxf';
/** Parameters of a query, with booleans in the place of their words. */
type Parameters<Query> = { [Name in keyof Query]: NonNullable<Query[Name]> extends 'true' | 'false' ? boolean | Query[Name] : Query[Name] };
/** Parameters of a flat pattern, by which `pattern` draws it. */
export type PatternParameters = Parameters<NonNullable<operations['getPattern']['parameters']['query']>>;
/** Parameters of a table of parts, by which `schedule` writes it. */
export type ScheduleParameters = Parameters<NonNullable<operations['getSchedule']['parameters']['query']>>;

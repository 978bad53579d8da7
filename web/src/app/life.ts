// The life of a request: idle, submitting, running, and then shown, failed or cancelled. Every answer comes with the request
// that it answers, so the answer to an earlier request changes nothing, wherever it was computed.

import type { JobInfo, Kind } from 'plateau-client';
import type { ResultMesh } from '../stage/mesh';

/** The document as it was when it was asked for. `turn` orders requests; `stop` ends the wait for this one. */
export interface Asked {
  readonly turn: number;
  readonly kind: Kind;
  /** The request as JSON text. */
  readonly request: string;
  readonly title: string | null;
  /** Whether it is a moment within a drag, which the end of the drag replaces. */
  readonly dragging: boolean;
  /** When it began, by the page's clock. */
  since: number;
  readonly stop: AbortController;
  readonly source: Source;
}

/** Where a request is solved: by the service, or by a solver within the page. */
export interface Source {
  /** Gives the job of a request, which may have ended already. It is not aborted, so that an unwanted job can be cancelled. */
  submit(asked: Asked): Promise<JobInfo>;
  /** Follows a job until it has ended. */
  follow(job: JobInfo, asked: Asked): Promise<JobInfo>;
  mesh(job: JobInfo, asked: Asked): Promise<ResultMesh>;
  cancel(job: JobInfo): Promise<unknown>;
}

export type Life =
  | { phase: 'idle' }
  | { phase: 'submitting'; asked: Asked }
  | { phase: 'running'; asked: Asked; job: JobInfo }
  | { phase: 'shown'; asked: Asked; job: JobInfo }
  | { phase: 'failed'; asked: Asked; job: JobInfo | null; error: unknown }
  | { phase: 'cancelled'; asked: Pick<Asked, 'kind' | 'request'> };

/** The phases that follow each phase for the same request. A new request may follow all of them. */
const NEXT: Record<Life['phase'], Life['phase'][]> = {
  idle: [], submitting: ['running', 'shown', 'failed', 'cancelled'], running: ['shown', 'failed', 'cancelled'], shown: [], failed: [], cancelled: [],
};

/** The one request that the page is concerned with, and the one that waits for its end. */
export class Requests {
  life: Life = { phase: 'idle' };
  private waiting: Asked | null = null;

  /** The request under way; null if none is. */
  get underWay(): Asked | null { return this.life.phase === 'submitting' || this.life.phase === 'running' ? this.life.asked : null; }
  get job(): JobInfo | null { return 'job' in this.life ? this.life.job : null; }
  get hasWaiting(): boolean { return this.waiting !== null; }

  /** Whether an answer to this request still counts. */
  isCurrent(asked: Asked): boolean { return this.underWay === asked; }

  /** Takes a new request. Gives true if it begins now, and false if it waits in place of the one that waited before. */
  ask(asked: Asked): boolean {
    if (this.underWay) {
      this.waiting = asked;
      return false;
    }
    this.life = { phase: 'submitting', asked };
    return true;
  }

  /** Enters the next phase of a request. Gives false and changes nothing if the request is no longer the current one. */
  enter(life: Exclude<Life, { phase: 'idle' }>): boolean {
    if (this.underWay !== life.asked || !NEXT[this.life.phase].includes(life.phase)) return false;
    this.life = life;
    return true;
  }

  /** Takes the request that waited, which now begins. */
  next(): Asked | null {
    const { waiting } = this;
    if (waiting) this.life = { phase: 'submitting', asked: waiting };
    this.waiting = null;
    return waiting;
  }

  /** A request that was cancelled at the last visit. */
  wasCancelled(kind: Kind, request: string): void {
    if (!this.underWay) this.life = { phase: 'cancelled', asked: { kind, request } };
  }

  /** Forgets the request that waits. */
  dropWaiting(): void {
    this.waiting = null;
  }
}

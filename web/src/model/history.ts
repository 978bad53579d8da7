// The document that is edited, with full undo and redo. Every change is one step, and a step holds the document as it was: the
// kind, the request, and the line that is being drawn.

import type { Kind } from 'plateau-client';
import type { Request, Vec3 } from './request';

/** `serial` tells documents apart that were opened one after another. */
export interface Document { kind: Kind; request: Request; draft: Vec3[] | null; title: string | null; serial?: number }

const MOST_STEPS = 500;
/** Characters of all steps together; the oldest are forgotten beyond it. */
const MOST_CHARACTERS = 40_000_000;

export class History {
  document: Document;
  private past: string[] = [];
  private future: string[] = [];
  private opened: string | null = null;

  constructor(document: Document) {
    this.document = document;
  }

  get canUndo(): boolean { return this.past.length > 0; }
  get canRedo(): boolean { return this.future.length > 0; }

  /** Begins a change that takes a while, such as a drag; `commit` ends it. What happens in between is one step. */
  begin(): void {
    this.opened ??= JSON.stringify(this.document);
  }

  /** Ends a change; gives whether the document differs from what it was. */
  commit(): boolean {
    const before = this.opened;
    this.opened = null;
    if (before === null || before === JSON.stringify(this.document)) return false;
    this.past.push(before);
    this.future = [];
    let size = this.past.reduce((sum, step) => sum + step.length, 0);
    while (this.past.length > MOST_STEPS || (size > MOST_CHARACTERS && this.past.length > 1)) size -= this.past.shift()!.length;
    return true;
  }

  /** Gives up a change that was begun: the document is again what it was before it. */
  abandon(): void {
    if (this.opened !== null) this.document = JSON.parse(this.opened) as Document;
    this.opened = null;
  }

  /** One change as one step; a change inside another one belongs to that. */
  edit(change: (document: Document) => void): boolean {
    const nested = this.opened !== null;
    this.begin();
    change(this.document);
    return nested || this.commit();
  }

  /** Changes what the last step made, without a step of its own. */
  amend(change: (document: Document) => void): void { change(this.document); }

  undo(): boolean { return this.step(this.past, this.future); }
  redo(): boolean { return this.step(this.future, this.past); }

  private step(from: string[], to: string[]): boolean {
    if (this.opened !== null) this.commit();
    const next = from.pop();
    if (next === undefined) return false;
    to.push(JSON.stringify(this.document));
    this.document = JSON.parse(next) as Document;
    return true;
  }
}

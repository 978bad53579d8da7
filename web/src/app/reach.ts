// Waits for a service that could not be reached.

import { page } from '../api';

const AGAIN_MS = 2000;
let waiting = 0;

/** Calls back once the service answers again, unless somebody else waits for it by then. */
export function whenBack(then: () => void): void {
  waiting += 1;
  const own = waiting;
  const ask = async (): Promise<void> => {
    if (own !== waiting) return;
    try {
      // Every answer will do.
      await fetch(page, { method: 'HEAD', cache: 'no-store' });
    } catch {
      setTimeout(() => void ask(), AGAIN_MS);
      return;
    }
    if (own !== waiting) return;
    waiting += 1;
    then();
  };
  setTimeout(() => void ask(), AGAIN_MS);
}

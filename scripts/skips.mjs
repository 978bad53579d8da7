// Records which tests in JavaScript are left out. scripts/skips.py and scripts/skips.sh do the same for Python and the shell.

import { appendFileSync } from 'node:fs';

/**
 * Skips a test if there is a reason to, and returns whether it is skipped: `if (isSkipped(t, WHAT, REASON)) return;`. The file
 * that PLATEAU_SKIPS names gets the line `WHAT: REASON`. `what` is a key without numbers and paths, which tests/allowed-skips.txt
 * can hold.
 */
export function isSkipped(t, what, reason) {
  if (!reason) return false;
  if (process.env.PLATEAU_SKIPS) appendFileSync(process.env.PLATEAU_SKIPS, `${what}: ${reason}\n`);
  t.skip(reason);
  return true;
}

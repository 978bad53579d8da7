// Holds a server's jobs at a stage, so that no test depends on how long a solver takes.
// src/test_hooks.rs has the other side: the server needs the feature `test-hooks`.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { readdir, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

/** Looks again and again until the condition holds, for longer than any step takes on any machine. */
export async function until(what, condition) {
  const end = performance.now() + 120_000;
  while (!(await condition())) {
    assert.ok(performance.now() < end, `never seen: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 10)); // between two looks
  }
}

/** The holds of one server. */
export class Hold {
  #folder;

  constructor(folder) {
    mkdirSync(folder);
    this.#folder = folder;
  }

  /** What the server must find in its environment. */
  get environment() {
    return { PLATEAU_TEST_HOLD_DIR: this.#folder };
  }

  /**
   * Holds every job that reaches the stage, until `release`: `claimed`, `first_progress`, `half` or `storing`. At
   * `each_progress`, a solver waits after each report until clients can see it.
   */
  at(stage) {
    return writeFile(join(this.#folder, stage), '');
  }

  release(stage) {
    return rm(join(this.#folder, stage), { force: true });
  }

  /** Removes every hold. */
  async releaseAll() {
    const names = (await readdir(this.#folder)).filter((name) => !name.startsWith('held.'));
    await Promise.all(names.map((name) => this.release(name)));
  }

  /** Whether a job is held now. */
  async holdsOne() {
    return (await readdir(this.#folder)).some((name) => name.startsWith('held.'));
  }

  /** Runs a part of a test while every job that reaches the stage is held. */
  async during(stage, part) {
    await this.at(stage);
    try {
      await part();
    } finally {
      await this.release(stage);
    }
  }
}

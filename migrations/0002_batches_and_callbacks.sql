-- Jobs that were submitted together, and URLs to tell of an end. Additions only: an older version neither knows nor needs them.

-- The batch a job came with, and its place in it.
ALTER TABLE jobs ADD COLUMN batch TEXT;
ALTER TABLE jobs ADD COLUMN batch_index BIGINT NOT NULL DEFAULT 0;

-- The outbox is the job's own row: it is due once the job has ended, whoever ended it, and until the URL is taken away. So no
-- end can be without its message, and no message without its end.
ALTER TABLE jobs ADD COLUMN callback_url TEXT;
ALTER TABLE jobs ADD COLUMN callback_attempts BIGINT NOT NULL DEFAULT 0;
-- Not before this time.
ALTER TABLE jobs ADD COLUMN callback_at BIGINT NOT NULL DEFAULT 0;

CREATE INDEX jobs_by_batch ON jobs (batch, batch_index) WHERE batch IS NOT NULL;
CREATE INDEX jobs_to_call_back ON jobs (callback_at) WHERE callback_url IS NOT NULL AND finished_at IS NOT NULL;

CREATE TABLE batches (
    id TEXT PRIMARY KEY NOT NULL,
    owner TEXT NOT NULL,
    created_at BIGINT NOT NULL,
    -- Jobs at submission.
    size BIGINT NOT NULL,
    idempotency_key TEXT,
    body_hash BYTEA NOT NULL,
    -- As a job's; due once every job of the batch has ended.
    callback_url TEXT,
    callback_attempts BIGINT NOT NULL DEFAULT 0,
    callback_at BIGINT NOT NULL DEFAULT 0
);
CREATE UNIQUE INDEX batches_idempotency ON batches (owner, idempotency_key) WHERE idempotency_key IS NOT NULL;
CREATE INDEX batches_to_call_back ON batches (callback_at) WHERE callback_url IS NOT NULL;

-- One text for SQLite and PostgreSQL. SQLite takes BYTEA columns as they are: blobs are stored unchanged.
-- Times are milliseconds since 1970 by the database's clock.

CREATE TABLE jobs (
    id TEXT PRIMARY KEY NOT NULL,
    kind TEXT NOT NULL,
    -- The name of the key that posted the job; '' without keys.
    owner TEXT NOT NULL,
    status TEXT NOT NULL,
    -- Counts claims; the fence of every write by a worker.
    attempt BIGINT NOT NULL,
    -- Counts changes over the job's whole life.
    sequence BIGINT NOT NULL,
    -- Leases that ran out, that is, workers that died or stalled on this job.
    lost_leases BIGINT NOT NULL DEFAULT 0,
    -- The fair queue's order: see src/store/queue.rs.
    turn BIGINT NOT NULL,
    worker TEXT,
    lease_until BIGINT,
    created_at BIGINT NOT NULL,
    started_at BIGINT,
    finished_at BIGINT,
    expires_at BIGINT,
    idempotency_key TEXT,
    body_hash BYTEA NOT NULL,
    -- Hash of kind, request and result version: equal hashes have equal results.
    content_hash BYTEA NOT NULL,
    -- 1 if another job with the same content may share this one's result.
    reusable BIGINT NOT NULL DEFAULT 0,
    progress_sequence BIGINT NOT NULL DEFAULT 0,
    -- One line a status change: "attempt sequence status time".
    history TEXT NOT NULL,
    -- One line a lost lease, for the error of a job that keeps killing its workers.
    losses TEXT NOT NULL DEFAULT '',
    artefact BYTEA,
    progress TEXT,
    error TEXT,
    warnings TEXT NOT NULL,
    statistics TEXT
);

CREATE INDEX jobs_queued ON jobs (turn, id) WHERE status = 'queued';
CREATE INDEX jobs_queued_by_owner ON jobs (owner, turn) WHERE status = 'queued';
CREATE INDEX jobs_running ON jobs (lease_until) WHERE status = 'running';
CREATE INDEX jobs_by_owner ON jobs (owner, id);
CREATE INDEX jobs_by_expiry ON jobs (expires_at) WHERE expires_at IS NOT NULL;
CREATE INDEX jobs_by_artefact ON jobs (artefact) WHERE artefact IS NOT NULL;
CREATE INDEX jobs_reusable ON jobs (owner, content_hash, id) WHERE reusable = 1;
CREATE UNIQUE INDEX jobs_idempotency ON jobs (owner, kind, idempotency_key) WHERE idempotency_key IS NOT NULL;

-- Apart from the job, so that a change of status does not rewrite a large body; dropped when the job ends.
CREATE TABLE requests (
    job_id TEXT PRIMARY KEY NOT NULL,
    body BYTEA NOT NULL
);

-- Results by the hash of their bytes, shared by every job that has the same.
CREATE TABLE artefacts (
    hash BYTEA PRIMARY KEY NOT NULL,
    size BIGINT NOT NULL,
    -- The last time a job took this artefact as its own; the sweep leaves young ones alone.
    touched_at BIGINT NOT NULL,
    -- A large result's file in the results folder; its body is then NULL.
    file TEXT,
    body BYTEA
);
CREATE INDEX artefacts_by_file ON artefacts (file) WHERE file IS NOT NULL;

-- What is left of an expired job: enough to answer "gone" instead of "never was".
CREATE TABLE expired_jobs (
    id TEXT PRIMARY KEY NOT NULL,
    owner TEXT NOT NULL,
    expired_at BIGINT NOT NULL
);
CREATE INDEX expired_jobs_by_time ON expired_jobs (expired_at);

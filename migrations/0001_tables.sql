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
    -- Estimate of the memory that solving takes. A worker claims only jobs that fit into its free memory.
    memory_bytes BIGINT NOT NULL DEFAULT 0,
    -- Number of jobs that were claimed before this one because they needed less memory.
    overtaken BIGINT NOT NULL DEFAULT 0,
    worker TEXT,
    lease_until BIGINT,
    -- Length of the current lease. A lease that ends later than its length allows was given by a clock that has since been
    -- set back.
    lease_ms BIGINT NOT NULL DEFAULT 0,
    created_at BIGINT NOT NULL,
    started_at BIGINT,
    finished_at BIGINT,
    expires_at BIGINT,
    -- The batch that the job belongs to, and its place in it.
    batch TEXT,
    batch_index BIGINT NOT NULL DEFAULT 0,
    -- A name for people, and a JSON object. Both are the client's.
    label TEXT,
    metadata TEXT,
    -- Key of a series of jobs of which only the newest counts.
    supersede TEXT,
    idempotency_key TEXT,
    body_hash BYTEA NOT NULL,
    -- Hash of kind, request and result version: equal hashes have equal results.
    content_hash BYTEA NOT NULL,
    -- Whether later equal requests may take the job's result:
    --   'undecided'  the client allows it; the result is still to come
    --   'allowed'    the result is there and may be taken
    --   'refused'    the client bypassed the cache, or the result depends on more than the request
    sharing TEXT NOT NULL,
    progress_sequence BIGINT NOT NULL DEFAULT 0,
    -- One line a status change: "attempt sequence status time".
    history TEXT NOT NULL,
    -- One line a lost lease, for the error of a job that keeps killing its workers.
    losses TEXT NOT NULL DEFAULT '',
    artefact BYTEA,
    progress TEXT,
    error TEXT,
    warnings TEXT NOT NULL,
    statistics TEXT,
    -- The few figures of the statistics that lists show, as JSON. Statistics may be long, so lists do not read them.
    summary TEXT,
    -- The row is the outbox of its callback, which is due once the job has ended in any way, and until the URL is taken
    -- away. So no end can be without its message, and no message without its end.
    callback_url TEXT,
    -- Host and port of the URL. A process leaves out the hosts that do not answer.
    callback_host TEXT,
    callback_attempts BIGINT NOT NULL DEFAULT 0,
    -- Attempts before the callback was last sent again. They do not count towards the limit of attempts.
    callback_base BIGINT NOT NULL DEFAULT 0,
    -- Not before this time.
    callback_at BIGINT NOT NULL DEFAULT 0,
    -- The URL of a callback that is settled, from which it can be sent again.
    callback_sent TEXT,
    -- One line an attempt: "number time outcome".
    deliveries TEXT NOT NULL DEFAULT ''
);

CREATE INDEX jobs_queued ON jobs (turn, id) WHERE status = 'queued';
CREATE INDEX jobs_queued_by_owner ON jobs (owner, turn) WHERE status = 'queued';
CREATE INDEX jobs_running ON jobs (lease_until) WHERE status = 'running';
-- Lists by kind and status read these two indexes instead of the rows of other jobs.
CREATE INDEX jobs_by_owner ON jobs (owner, id, kind, status);
CREATE INDEX jobs_by_id ON jobs (id, kind, status);
CREATE INDEX jobs_by_expiry ON jobs (expires_at) WHERE expires_at IS NOT NULL;
-- Finished jobs of each owner, oldest first.
CREATE INDEX jobs_by_owner_and_expiry ON jobs (owner, expires_at, id) WHERE expires_at IS NOT NULL;
CREATE INDEX jobs_by_artefact ON jobs (artefact) WHERE artefact IS NOT NULL;
CREATE INDEX jobs_shared ON jobs (owner, content_hash, id) WHERE sharing = 'allowed';
CREATE UNIQUE INDEX jobs_idempotency ON jobs (owner, kind, idempotency_key) WHERE idempotency_key IS NOT NULL;
-- Finds the job that a client submitted with a key when it never learned the job's id.
CREATE INDEX jobs_by_idempotency_key ON jobs (idempotency_key, id) WHERE idempotency_key IS NOT NULL;
CREATE INDEX jobs_by_supersede ON jobs (owner, supersede, id) WHERE supersede IS NOT NULL AND finished_at IS NULL;
CREATE INDEX jobs_by_batch ON jobs (batch, batch_index) WHERE batch IS NOT NULL;
CREATE INDEX jobs_to_call_back ON jobs (callback_at) WHERE callback_url IS NOT NULL AND finished_at IS NOT NULL;

-- Apart from the job, so that a change of status does not rewrite a large body; dropped when the job ends.
CREATE TABLE requests (
    job_id TEXT PRIMARY KEY NOT NULL,
    body BYTEA NOT NULL,
    -- Name of the result from which the request begins. The result is kept as long as this row.
    source BYTEA
);
CREATE INDEX requests_by_source ON requests (source) WHERE source IS NOT NULL;

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

-- Jobs that were submitted together.
CREATE TABLE batches (
    id TEXT PRIMARY KEY NOT NULL,
    owner TEXT NOT NULL,
    created_at BIGINT NOT NULL,
    -- Jobs at submission.
    size BIGINT NOT NULL,
    idempotency_key TEXT,
    body_hash BYTEA NOT NULL,
    -- The callback's columns mean what a job's do. The callback is due once every job of the batch has ended.
    callback_url TEXT,
    callback_host TEXT,
    callback_attempts BIGINT NOT NULL DEFAULT 0,
    callback_base BIGINT NOT NULL DEFAULT 0,
    callback_at BIGINT NOT NULL DEFAULT 0,
    callback_sent TEXT,
    deliveries TEXT NOT NULL DEFAULT ''
);
CREATE UNIQUE INDEX batches_idempotency ON batches (owner, idempotency_key) WHERE idempotency_key IS NOT NULL;
CREATE INDEX batches_to_call_back ON batches (callback_at) WHERE callback_url IS NOT NULL;

-- Tasks that one process at a time does for all that share the database, such as the sweep.
CREATE TABLE leaders (
    task TEXT PRIMARY KEY NOT NULL,
    -- The process that does the task.
    holder TEXT NOT NULL,
    -- Time until which the process may be away before another one takes the task.
    held_until BIGINT NOT NULL
);

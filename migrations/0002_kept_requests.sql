-- Requests are kept as long as their jobs, cancelled jobs say why, and lists select by label. The columns have defaults,
-- so that an older version keeps working on this database.

-- Size of the job's row in `requests`; 0 if there is none.
ALTER TABLE jobs ADD COLUMN request_bytes BIGINT NOT NULL DEFAULT 0;
-- Why the job was cancelled: see `CancelReason` in src/status.rs.
ALTER TABLE jobs ADD COLUMN cancelled_because TEXT;
-- The job that cancelled this one by taking its place in a series.
ALTER TABLE jobs ADD COLUMN successor TEXT;
-- Time at which a worker first handed the job back because its version could not read the request.
ALTER TABLE jobs ADD COLUMN unread_since BIGINT;
-- The error, as JSON, of a job that no worker could read in time.
ALTER TABLE jobs ADD COLUMN unread_error TEXT;

UPDATE jobs SET request_bytes = (SELECT length(body) FROM requests WHERE job_id = jobs.id)
    WHERE EXISTS (SELECT 1 FROM requests WHERE job_id = jobs.id);

CREATE INDEX jobs_by_label ON jobs (label, id) WHERE label IS NOT NULL;
CREATE INDEX jobs_unread ON jobs (unread_since) WHERE unread_since IS NOT NULL;
-- The index has the sizes of the requests too, so that their sum for each owner reads no rows.
DROP INDEX jobs_by_owner_and_expiry;
CREATE INDEX jobs_by_owner_and_expiry ON jobs (owner, expires_at, id, request_bytes) WHERE expires_at IS NOT NULL;

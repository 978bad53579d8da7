-- Indexes only: an older version needs none of them.

-- Lists by kind and status read these indexes instead of the rows of other jobs.
DROP INDEX jobs_by_owner;
CREATE INDEX jobs_by_owner ON jobs (owner, id, kind, status);
CREATE INDEX jobs_by_id ON jobs (id, kind, status);
-- Finished jobs of each owner, oldest first.
CREATE INDEX jobs_by_owner_and_expiry ON jobs (owner, expires_at, id) WHERE expires_at IS NOT NULL;

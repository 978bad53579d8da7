-- Whether later equal requests may take a job's result, in words instead of the numbers of `reusable`:
--   'undecided'  the client allows it; the result is still to come
--   'allowed'    the result is there and may be taken
--   'refused'    the client bypassed the cache, or the result depends on more than the request
-- The column `reusable` stays for older versions, which do not share results with newer ones.
ALTER TABLE jobs ADD COLUMN sharing TEXT NOT NULL DEFAULT 'refused';
UPDATE jobs SET sharing = CASE
    WHEN reusable = 1 THEN 'allowed'
    WHEN reusable = 0 AND finished_at IS NULL THEN 'undecided'
    ELSE 'refused' END;
DROP INDEX jobs_reusable;
CREATE INDEX jobs_shared ON jobs (owner, content_hash, id) WHERE sharing = 'allowed';

-- Length of the current lease. A lease that ends later than its length allows was given by a clock that has since been
-- set back. The default, ten years, is for leases of older versions.
ALTER TABLE jobs ADD COLUMN lease_ms BIGINT NOT NULL DEFAULT 315360000000;

-- Finds the job that a client submitted with a key when it never learned the job's id.
CREATE INDEX jobs_by_idempotency_key ON jobs (idempotency_key, id) WHERE idempotency_key IS NOT NULL;

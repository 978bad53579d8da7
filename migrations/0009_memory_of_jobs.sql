-- Additions only: an older version neither knows nor needs them.

-- Estimate of the memory that solving takes. A worker claims only jobs that fit into its free memory.
ALTER TABLE jobs ADD COLUMN memory_bytes BIGINT NOT NULL DEFAULT 0;
-- Number of jobs that were claimed before this one because they needed less memory.
ALTER TABLE jobs ADD COLUMN overtaken BIGINT NOT NULL DEFAULT 0;

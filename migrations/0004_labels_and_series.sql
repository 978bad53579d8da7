-- Additions only: an older version neither knows nor needs them.

-- What the client said of its job: a name for people, and a JSON object.
ALTER TABLE jobs ADD COLUMN label TEXT;
ALTER TABLE jobs ADD COLUMN metadata TEXT;

-- Key of a series of jobs of which only the newest counts.
ALTER TABLE jobs ADD COLUMN supersede TEXT;
CREATE INDEX jobs_by_supersede ON jobs (owner, supersede, id) WHERE supersede IS NOT NULL AND finished_at IS NULL;

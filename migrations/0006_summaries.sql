-- Additions only: an older version neither knows nor needs them.

-- The few figures of a job's statistics that lists show, as JSON. Statistics may be long, so lists do not read them.
ALTER TABLE jobs ADD COLUMN summary TEXT;

-- Additions only: an older version neither knows nor needs them.

-- Random bytes that all processes on this database share, such as those that tickets of event streams are signed with.
CREATE TABLE secrets (
    name TEXT PRIMARY KEY NOT NULL,
    value BYTEA NOT NULL
);

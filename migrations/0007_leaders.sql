-- Additions only: an older version neither knows nor needs them.

-- Tasks that one process at a time does for all that share the database, such as the sweep.
CREATE TABLE leaders (
    task TEXT PRIMARY KEY NOT NULL,
    -- The process that does the task.
    holder TEXT NOT NULL,
    -- Time until which the process may be away before another one takes the task.
    held_until BIGINT NOT NULL
);

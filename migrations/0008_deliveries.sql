-- Additions only: an older version neither knows nor needs them.

-- Host and port of the callback's URL. A process leaves out the hosts that do not answer.
ALTER TABLE jobs ADD COLUMN callback_host TEXT;
ALTER TABLE batches ADD COLUMN callback_host TEXT;

-- The URL of a callback that is settled, from which it can be sent again.
ALTER TABLE jobs ADD COLUMN callback_sent TEXT;
ALTER TABLE batches ADD COLUMN callback_sent TEXT;

-- Attempts before the callback was last sent again. They do not count towards the limit of attempts.
ALTER TABLE jobs ADD COLUMN callback_base BIGINT NOT NULL DEFAULT 0;
ALTER TABLE batches ADD COLUMN callback_base BIGINT NOT NULL DEFAULT 0;

-- One line an attempt: "number time outcome".
ALTER TABLE jobs ADD COLUMN deliveries TEXT NOT NULL DEFAULT '';
ALTER TABLE batches ADD COLUMN deliveries TEXT NOT NULL DEFAULT '';

-- What a change left behind: a line for each sealed object (db/seals.h), with its checksum; and the station that
-- wrote the entry, with its signature over the chain. Empty in entries from before.
ALTER TABLE audit ADD COLUMN seals TEXT NOT NULL DEFAULT '';

ALTER TABLE audit ADD COLUMN station TEXT NOT NULL DEFAULT '';

ALTER TABLE audit ADD COLUMN signature TEXT NOT NULL DEFAULT '';

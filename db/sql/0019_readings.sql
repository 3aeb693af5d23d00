-- Of an attempt of another build: the version of Placode that has read its recording and found nothing that differs.
-- Only its own build simulates it again, so that version need not read it a second time. Empty: none has.
ALTER TABLE attempts ADD COLUMN read_by TEXT NOT NULL DEFAULT '';

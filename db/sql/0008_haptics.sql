-- What the haptic loop of an attempt did (JSON), its grade (not_applicable, sound, bad; empty: none was kept), and
-- why an exam attempt does not count although it was finished: the machine failed, not the person.
ALTER TABLE attempts ADD COLUMN haptic_certificate TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN haptic_grade TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN void_reason TEXT NOT NULL DEFAULT '';

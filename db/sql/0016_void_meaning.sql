-- What the reason means, as JSON (db/void_reason.h): it is put into words when it is shown. Empty where there is none,
-- and for what an older program wrote.
ALTER TABLE attempts ADD COLUMN void_meaning TEXT NOT NULL DEFAULT '';

-- Likewise of why an attempt does not do its step of a study.
ALTER TABLE study_steps ADD COLUMN detail_meaning TEXT NOT NULL DEFAULT '';

-- What a reason means, as JSON (db/reason_json.h): it is put into words when it is shown. Empty for what an
-- older program scored.
ALTER TABLE attempt_reasons ADD COLUMN meaning TEXT NOT NULL DEFAULT '';

ALTER TABLE attempt_score_reasons ADD COLUMN meaning TEXT NOT NULL DEFAULT '';

-- Whether the inputs of an attempt were simulated again: 0 = not replayed (practice, and everything made before), 1 =
-- waiting (counts once it is identical), 2 = identical, 3 = differs (void_reason says where).
ALTER TABLE attempts ADD COLUMN replay {INT64} NOT NULL DEFAULT 0;

ALTER TABLE attempts ADD COLUMN replayed_utc TEXT NOT NULL DEFAULT '';

-- As 0011, with the replay: where people stand is still answered from the index alone.
DROP INDEX attempts_by_person_and_task;

CREATE INDEX attempts_by_person_and_task ON attempts (account_id, task_id, started_utc, id, points, verdict, end_reason, void_reason, replay, study, device, demonstration);

-- The same recording for two people is found by its end.
CREATE INDEX attempts_by_final_hash ON attempts (final_hash);

-- Where everybody stands is asked by every page of a cohort: with void_reason (since 0008), device and
-- demonstration in it, the index answers by itself.
DROP INDEX attempts_by_person_and_task;

CREATE INDEX attempts_by_person_and_task ON attempts (account_id, task_id, started_utc, id, points, verdict, end_reason, void_reason, device, demonstration);

-- Of a study: whose code the attempt belongs to. The account is who was signed in; such an attempt is
-- never that person's own. Empty = of a person.
ALTER TABLE attempts ADD COLUMN study TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN participant TEXT NOT NULL DEFAULT '';

UPDATE attempts SET study = (SELECT MIN(s.study_id) FROM study_steps s WHERE s.attempt_id = attempts.id), participant = (SELECT MIN(s.code) FROM study_steps s WHERE s.attempt_id = attempts.id) WHERE id IN (SELECT attempt_id FROM study_steps WHERE attempt_id > 0);

-- As 0010, with the study: where people stand is still answered from the index alone.
DROP INDEX attempts_by_person_and_task;

CREATE INDEX attempts_by_person_and_task ON attempts (account_id, task_id, started_utc, id, points, verdict, end_reason, void_reason, study, device, demonstration);

-- A page of a list finds its attempts in an index alone, too.
DROP INDEX attempts_by_time;

CREATE INDEX attempts_by_time ON attempts (started_utc, id, study);

DROP INDEX attempts_by_task;

CREATE INDEX attempts_by_task ON attempts (task_id, started_utc, id, study);

-- Steps that a coordinator had done again: kept and marked, they count no more.
CREATE TABLE superseded_steps (
    step_id {INT64} PRIMARY KEY REFERENCES study_steps (id) ON DELETE CASCADE,
    reason TEXT NOT NULL,
    superseded_by TEXT NOT NULL,
    superseded_utc TEXT NOT NULL
) {STRICT};

-- What a coordinator remarks on a step.
CREATE TABLE step_notes (
    id {ID},
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    visit {INT64} NOT NULL,
    step TEXT NOT NULL,
    note TEXT NOT NULL,
    noted_by TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

CREATE INDEX step_notes_by_study ON step_notes (study_id, code);

-- The device that the coordinator chose for a participant where the protocol names none.
CREATE TABLE participant_devices (
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    device TEXT NOT NULL,
    chosen_by TEXT NOT NULL,
    chosen_utc TEXT NOT NULL,
    PRIMARY KEY (study_id, code),
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

-- Exams that were begun. Each has shown a case and uses up an attempt, whatever becomes of the recording. Rows are never
-- changed: the attempt that ends one refers to it.
CREATE TABLE exam_begins (
    id {ID},
    account_id {INT64} NOT NULL REFERENCES accounts (id),
    course_id TEXT NOT NULL,
    course_version {INT64} NOT NULL,
    stage_id TEXT NOT NULL,
    task_id TEXT NOT NULL,
    task_version {INT64} NOT NULL,
    seed TEXT NOT NULL,
    proctor TEXT NOT NULL,
    device_certificate TEXT NOT NULL,
    begun_utc TEXT NOT NULL
) {STRICT};

CREATE INDEX exam_begins_by_account ON exam_begins (account_id);

-- 0 = practice, an import, or an exam from before.
ALTER TABLE attempts ADD COLUMN exam_begin {INT64} NOT NULL DEFAULT 0;

-- Of the person's own: nobody else's row keeps an exam from being saved.
CREATE UNIQUE INDEX attempts_by_exam_begin ON attempts (account_id, exam_begin) WHERE exam_begin <> 0;

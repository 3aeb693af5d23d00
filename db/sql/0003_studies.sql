-- Pseudonymous: there is no link to an account here.
CREATE TABLE participants (
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    number {INT64} NOT NULL,
    created_utc TEXT NOT NULL,
    PRIMARY KEY (study_id, code),
    UNIQUE (study_id, number)
) {STRICT};

CREATE TABLE answers (
    id {ID},
    study_id TEXT NOT NULL,
    participant TEXT NOT NULL,
    questionnaire_id TEXT NOT NULL,
    questionnaire_version {INT64} NOT NULL,
    answered_utc TEXT NOT NULL,
    demonstration {INT64} NOT NULL CHECK (demonstration IN (0, 1)),
    FOREIGN KEY (study_id, participant) REFERENCES participants (study_id, code)
) {STRICT};

CREATE INDEX answers_by_study ON answers (study_id);

CREATE TABLE answer_items (
    answer_id {INT64} NOT NULL REFERENCES answers (id),
    item TEXT NOT NULL,
    answer TEXT NOT NULL,
    PRIMARY KEY (answer_id, item)
) {STRICT};

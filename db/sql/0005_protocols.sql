-- Published questionnaires and studies: text that is never edited, so that old answers stay
-- readable. reason says why there is a version after the first (amendment).
CREATE TABLE definitions (
    kind TEXT NOT NULL,
    id TEXT NOT NULL,
    version {INT64} NOT NULL,
    content TEXT NOT NULL,
    checksum TEXT NOT NULL,
    reason TEXT NOT NULL,
    published_by TEXT NOT NULL,
    published_utc TEXT NOT NULL,
    PRIMARY KEY (kind, id, version)
) {STRICT};

-- sqlite only
CREATE TRIGGER definitions_are_never_changed BEFORE UPDATE ON definitions
BEGIN
    SELECT RAISE(ABORT, 'a published definition is never changed; publish a new version');
END;

-- sqlite only
CREATE TRIGGER definitions_are_never_deleted BEFORE DELETE ON definitions
BEGIN
    SELECT RAISE(ABORT, 'a published definition is never deleted');
END;

-- postgresql only
CREATE FUNCTION definitions_are_immutable() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
    RAISE EXCEPTION 'a published definition is never changed; publish a new version';
END $$;

-- postgresql only
CREATE TRIGGER definitions_are_never_changed BEFORE UPDATE OR DELETE OR TRUNCATE ON definitions
    FOR EACH STATEMENT EXECUTE FUNCTION definitions_are_immutable();

-- Drawn when a study with arms is published; decimal text, because it is unsigned. Never shown.
CREATE TABLE study_allocations (
    study_id TEXT PRIMARY KEY,
    seed TEXT NOT NULL
) {STRICT};

-- What is known of a participant beyond the code.
CREATE TABLE participant_states (
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    protocol_version {INT64} NOT NULL,
    arm {INT64} NOT NULL,
    demonstration {INT64} NOT NULL CHECK (demonstration IN (0, 1)),
    PRIMARY KEY (study_id, code),
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

-- The tombstone: it stays, whatever becomes of the data. mode: keep, stop or erase.
CREATE TABLE withdrawals (
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    mode TEXT NOT NULL CHECK (mode IN ('keep', 'stop', 'erase')),
    reason TEXT NOT NULL,
    withdrawn_by TEXT NOT NULL,
    withdrawn_utc TEXT NOT NULL,
    PRIMARY KEY (study_id, code),
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

-- What was done when. attempt_id and answer_id: 0 = none. detail of a consent: its version, the
-- language and the checksum of the text that was read.
CREATE TABLE study_steps (
    id {ID},
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    visit {INT64} NOT NULL,
    step TEXT NOT NULL,
    state TEXT NOT NULL CHECK (state IN ('started', 'done', 'skipped')),
    attempt_id {INT64} NOT NULL,
    answer_id {INT64} NOT NULL,
    detail TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

CREATE INDEX study_steps_by_study ON study_steps (study_id, code);

-- Every change of an answer before it was submitted.
CREATE TABLE answer_changes (
    answer_id {INT64} NOT NULL REFERENCES answers (id),
    position {INT64} NOT NULL,
    item TEXT NOT NULL,
    old_answer TEXT NOT NULL,
    new_answer TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    PRIMARY KEY (answer_id, position)
) {STRICT};

ALTER TABLE answers ADD COLUMN language TEXT NOT NULL DEFAULT 'en';

ALTER TABLE answers ADD COLUMN visit {INT64} NOT NULL DEFAULT 1;

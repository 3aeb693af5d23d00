-- What happened to the record of a participant as a whole: locked, signed, unlocked (which cancels
-- the signature). checksum binds a signature to the record as it was. Never changed or deleted.
CREATE TABLE record_events (
    id {ID},
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    event TEXT NOT NULL CHECK (event IN ('locked', 'signed', 'unlocked')),
    remark TEXT NOT NULL,
    checksum TEXT NOT NULL,
    by_login TEXT NOT NULL,
    by_name TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

CREATE INDEX record_events_by_study ON record_events (study_id, code);

-- Answers changed after they were submitted; the old one stays readable here. entry: 1 = the answers
-- themselves, 2 = their second entry from paper.
CREATE TABLE answer_corrections (
    id {ID},
    answer_id {INT64} NOT NULL REFERENCES answers (id) ON DELETE CASCADE,
    entry {INT64} NOT NULL CHECK (entry IN (1, 2)),
    item TEXT NOT NULL,
    old_answer TEXT NOT NULL,
    new_answer TEXT NOT NULL,
    reason TEXT NOT NULL,
    corrected_by TEXT NOT NULL,
    at_utc TEXT NOT NULL
) {STRICT};

CREATE INDEX answer_corrections_by_answer ON answer_corrections (answer_id);

-- The same answers, typed a second time from paper.
CREATE TABLE second_entries (
    answer_id {INT64} PRIMARY KEY REFERENCES answers (id) ON DELETE CASCADE,
    entered_by TEXT NOT NULL,
    at_utc TEXT NOT NULL
) {STRICT};

CREATE TABLE second_entry_items (
    answer_id {INT64} NOT NULL REFERENCES second_entries (answer_id) ON DELETE CASCADE,
    item TEXT NOT NULL,
    answer TEXT NOT NULL,
    PRIMARY KEY (answer_id, item)
) {STRICT};

-- The hand's lines under a consent, as the path of an SVG. Names a person: in no export, and gone
-- when the data are erased.
CREATE TABLE consent_signatures (
    study_id TEXT NOT NULL,
    code TEXT NOT NULL,
    path TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    PRIMARY KEY (study_id, code),
    FOREIGN KEY (study_id, code) REFERENCES participants (study_id, code)
) {STRICT};

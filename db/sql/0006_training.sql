-- Groups (cohorts). teaches: 1 = educator of the group.
CREATE TABLE training_groups (
    id {ID},
    name TEXT NOT NULL,
    name_key TEXT NOT NULL UNIQUE,
    created_utc TEXT NOT NULL
) {STRICT};

CREATE TABLE group_members (
    group_id {INT64} NOT NULL REFERENCES training_groups (id),
    account_id {INT64} NOT NULL REFERENCES accounts (id),
    teaches {INT64} NOT NULL CHECK (teaches IN (0, 1)),
    PRIMARY KEY (group_id, account_id)
) {STRICT};

CREATE INDEX group_members_by_account ON group_members (account_id);

-- A published version of a course, for a person or a group (the other one is NULL). Empty dates:
-- at once, without an end. ended_utc is empty while it holds.
CREATE TABLE course_assignments (
    id {ID},
    course_id TEXT NOT NULL,
    course_version {INT64} NOT NULL,
    account_id {INT64} REFERENCES accounts (id),
    group_id {INT64} REFERENCES training_groups (id),
    starts_utc TEXT NOT NULL,
    due_utc TEXT NOT NULL,
    assigned_by TEXT NOT NULL,
    assigned_utc TEXT NOT NULL,
    ended_utc TEXT NOT NULL,
    CHECK ((account_id IS NULL) <> (group_id IS NULL))
) {STRICT};

CREATE INDEX course_assignments_by_account ON course_assignments (account_id);

CREATE INDEX course_assignments_by_group ON course_assignments (group_id);

CREATE TABLE course_grants (
    id {ID},
    account_id {INT64} NOT NULL REFERENCES accounts (id),
    course_id TEXT NOT NULL,
    stage_id TEXT NOT NULL,
    attempts {INT64} NOT NULL,
    reason TEXT NOT NULL,
    granted_by TEXT NOT NULL,
    granted_utc TEXT NOT NULL
) {STRICT};

CREATE INDEX course_grants_by_account ON course_grants (account_id);

CREATE TABLE certificates (
    id {ID},
    account_id {INT64} NOT NULL REFERENCES accounts (id),
    course_id TEXT NOT NULL,
    course_version {INT64} NOT NULL,
    mastered_utc TEXT NOT NULL,
    issued_utc TEXT NOT NULL,
    issued_by TEXT NOT NULL,
    code TEXT NOT NULL UNIQUE,
    UNIQUE (account_id, course_id, course_version)
) {STRICT};

-- Which exam an attempt was; empty = practice.
ALTER TABLE attempts ADD COLUMN exam_course TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN exam_course_version {INT64} NOT NULL DEFAULT 0;

ALTER TABLE attempts ADD COLUMN exam_stage TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN proctor TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN device_certificate TEXT NOT NULL DEFAULT '';

-- How signals were prepared before metrics were computed from them.
ALTER TABLE attempts ADD COLUMN preprocessing_version {INT64} NOT NULL DEFAULT 1;

-- Multiplied from the attempt with this id, to measure the store; 0 = a real attempt.
ALTER TABLE attempts ADD COLUMN generated_from {INT64} NOT NULL DEFAULT 0;

-- Further scores of an attempt, under another rubric, metric set or pre-processing. The first one
-- stays in attempts, attempt_metrics and attempt_reasons.
CREATE TABLE attempt_scores (
    id {ID},
    attempt_id {INT64} NOT NULL REFERENCES attempts (id),
    points {REAL} NOT NULL,
    verdict {INT64} NOT NULL,
    rubric_id TEXT NOT NULL,
    rubric_version {INT64} NOT NULL,
    metric_set_version {INT64} NOT NULL,
    preprocessing_version {INT64} NOT NULL,
    scored_utc TEXT NOT NULL,
    scored_by TEXT NOT NULL,
    UNIQUE (attempt_id, rubric_id, rubric_version, metric_set_version, preprocessing_version)
) {STRICT};

CREATE TABLE attempt_score_metrics (
    score_id {INT64} NOT NULL REFERENCES attempt_scores (id),
    position {INT64} NOT NULL,
    metric_id TEXT NOT NULL,
    value {REAL},
    PRIMARY KEY (score_id, position)
) {STRICT};

CREATE TABLE attempt_score_reasons (
    score_id {INT64} NOT NULL REFERENCES attempt_scores (id),
    position {INT64} NOT NULL,
    item TEXT NOT NULL,
    reason TEXT NOT NULL,
    points {REAL} NOT NULL,
    time_s {REAL} NOT NULL,
    critical {INT64} NOT NULL CHECK (critical IN (0, 1)),
    PRIMARY KEY (score_id, position)
) {STRICT};

-- The centre's signing key (Ed25519, hexadecimal): one row. Who may read the store may sign.
CREATE TABLE centre_key (
    id {INT64} PRIMARY KEY CHECK (id = 1),
    centre TEXT NOT NULL,
    public_key TEXT NOT NULL,
    secret_key TEXT NOT NULL,
    made_utc TEXT NOT NULL
) {STRICT};

-- Centres whose norm packs are taken.
CREATE TABLE trusted_centres (
    public_key TEXT PRIMARY KEY,
    centre TEXT NOT NULL,
    added_by TEXT NOT NULL,
    added_utc TEXT NOT NULL
) {STRICT};

-- Aggregated bands, own and imported, as they were signed. in_use: 1 for at most one of a task.
CREATE TABLE norm_packs (
    id {ID},
    task_id TEXT NOT NULL,
    centre TEXT NOT NULL,
    content TEXT NOT NULL,
    signature TEXT NOT NULL,
    public_key TEXT NOT NULL,
    in_use {INT64} NOT NULL CHECK (in_use IN (0, 1)),
    added_by TEXT NOT NULL,
    added_utc TEXT NOT NULL,
    UNIQUE (signature)
) {STRICT};

-- Quick return at a shared station. failures: wrong ones in a row.
CREATE TABLE account_pins (
    account_id {INT64} PRIMARY KEY REFERENCES accounts (id),
    pin_hash TEXT NOT NULL,
    failures {INT64} NOT NULL
) {STRICT};

-- code_hash: BLAKE2b of the code, which is random and long; the code itself is nowhere.
CREATE TABLE invitations (
    id {ID},
    code_hash TEXT NOT NULL UNIQUE,
    roles {INT64} NOT NULL CHECK (roles BETWEEN 1 AND 255),
    group_id {INT64} REFERENCES training_groups (id),
    note TEXT NOT NULL,
    invited_by TEXT NOT NULL,
    made_utc TEXT NOT NULL,
    expires_utc TEXT NOT NULL,
    used_utc TEXT NOT NULL
) {STRICT};

CREATE TABLE erasure_requests (
    account_id {INT64} PRIMARY KEY REFERENCES accounts (id),
    reason TEXT NOT NULL,
    asked_utc TEXT NOT NULL,
    done_utc TEXT NOT NULL
) {STRICT};

-- Lists of everybody's attempts by time, of one task, and sums over a cohort without the rows.
CREATE INDEX attempts_by_time ON attempts (started_utc, id);

CREATE INDEX attempts_by_task ON attempts (task_id, started_utc, id);

CREATE INDEX attempts_by_person_and_task ON attempts (account_id, task_id, started_utc, id, points, verdict, end_reason);

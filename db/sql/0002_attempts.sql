-- seed and final_hash are unsigned 64-bit numbers, which neither engine has: decimal text.
CREATE TABLE attempts (
    id {ID},
    account_id {INT64} NOT NULL REFERENCES accounts (id),
    task_id TEXT NOT NULL,
    task_version {INT64} NOT NULL,
    started_utc TEXT NOT NULL,
    saved_utc TEXT NOT NULL,
    duration_s {REAL} NOT NULL,
    device TEXT NOT NULL,
    seed TEXT NOT NULL,
    build TEXT NOT NULL,
    end_reason {INT64} NOT NULL,
    final_hash TEXT NOT NULL,
    dropped {INT64} NOT NULL,
    demonstration {INT64} NOT NULL CHECK (demonstration IN (0, 1)),
    points {REAL} NOT NULL,
    verdict {INT64} NOT NULL,
    rubric_id TEXT NOT NULL,
    rubric_version {INT64} NOT NULL,
    metric_set_version {INT64} NOT NULL
) {STRICT};

CREATE INDEX attempts_by_account ON attempts (account_id, started_utc);

-- A value that is not a finite number is NULL.
CREATE TABLE attempt_metrics (
    attempt_id {INT64} NOT NULL REFERENCES attempts (id),
    position {INT64} NOT NULL,
    metric_id TEXT NOT NULL,
    value {REAL},
    PRIMARY KEY (attempt_id, position)
) {STRICT};

CREATE TABLE attempt_reasons (
    attempt_id {INT64} NOT NULL REFERENCES attempts (id),
    position {INT64} NOT NULL,
    item TEXT NOT NULL,
    reason TEXT NOT NULL,
    points {REAL} NOT NULL,
    time_s {REAL} NOT NULL,
    critical {INT64} NOT NULL CHECK (critical IN (0, 1)),
    PRIMARY KEY (attempt_id, position)
) {STRICT};

-- The ledger. value and value2 have the unit of their kind; NULL = not a finite number.
CREATE TABLE attempt_events (
    attempt_id {INT64} NOT NULL REFERENCES attempts (id),
    position {INT64} NOT NULL,
    time_s {REAL} NOT NULL,
    kind {INT64} NOT NULL,
    tool {INT64} NOT NULL,
    tissue {INT64} NOT NULL,
    value {REAL},
    value2 {REAL},
    rest_x_m {REAL},
    rest_y_m {REAL},
    rest_z_m {REAL},
    element {INT64} NOT NULL,
    PRIMARY KEY (attempt_id, position)
) {STRICT};

-- The recording file, byte for byte, compressed with zstd. The checksum is of the file.
CREATE TABLE recordings (
    attempt_id {INT64} PRIMARY KEY REFERENCES attempts (id),
    size_bytes {INT64} NOT NULL,
    checksum TEXT NOT NULL,
    content {BLOB} NOT NULL
) {STRICT};

CREATE INDEX recordings_by_checksum ON recordings (checksum);

-- How these files are read: statements are separated by an empty line; {ID}, {INT64}, {REAL},
-- {BLOB} and {STRICT} become the engine's own words; a statement that begins with the comment
-- "sqlite only" or "postgresql only" is skipped by the other engine. A file that was shipped is
-- never edited: its checksum is kept in every store.

-- An account is what training data refers to. It holds no name.
CREATE TABLE accounts (
    id {ID},
    password_hash TEXT NOT NULL,
    roles {INT64} NOT NULL CHECK (roles BETWEEN 0 AND 255),
    active {INT64} NOT NULL CHECK (active IN (0, 1)),
    demonstration {INT64} NOT NULL CHECK (demonstration IN (0, 1)),
    created_utc TEXT NOT NULL
) {STRICT};

-- Who an account is. Apart, so that a person can be erased and the training data stays.
CREATE TABLE persons (
    account_id {INT64} PRIMARY KEY REFERENCES accounts (id),
    login TEXT NOT NULL,
    login_key TEXT NOT NULL UNIQUE,
    display_name TEXT NOT NULL
) {STRICT};

-- Wrong passwords by login, whether such an account exists or not.
CREATE TABLE sign_in_failures (
    login_key TEXT PRIMARY KEY,
    failures {INT64} NOT NULL,
    last_ms {INT64} NOT NULL
) {STRICT};

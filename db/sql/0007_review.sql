-- What people remark on an attempt, at a time of the recording or (time_s < 0) on the whole of it. An
-- empty text is a bare mark. removed_utc is empty while the remark stands.
CREATE TABLE attempt_comments (
    id {ID},
    attempt_id {INT64} NOT NULL REFERENCES attempts (id) ON DELETE CASCADE,
    author_id {INT64} NOT NULL REFERENCES accounts (id),
    time_s {REAL} NOT NULL,
    comment TEXT NOT NULL,
    at_utc TEXT NOT NULL,
    removed_utc TEXT NOT NULL
) {STRICT};

CREATE INDEX attempt_comments_by_attempt ON attempt_comments (attempt_id);

-- Ratings by people beside the metrics: one of each rater and questionnaire for an attempt, kept as
-- it was given. blinded: 1 = the rater saw neither name nor score.
CREATE TABLE attempt_ratings (
    id {ID},
    attempt_id {INT64} NOT NULL REFERENCES attempts (id) ON DELETE CASCADE,
    rater_id {INT64} NOT NULL REFERENCES accounts (id),
    questionnaire_id TEXT NOT NULL,
    questionnaire_version {INT64} NOT NULL,
    blinded {INT64} NOT NULL CHECK (blinded IN (0, 1)),
    rated_utc TEXT NOT NULL,
    UNIQUE (attempt_id, rater_id, questionnaire_id)
) {STRICT};

CREATE TABLE attempt_rating_items (
    rating_id {INT64} NOT NULL REFERENCES attempt_ratings (id) ON DELETE CASCADE,
    item TEXT NOT NULL,
    answer TEXT NOT NULL,
    PRIMARY KEY (rating_id, item)
) {STRICT};

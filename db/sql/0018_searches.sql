-- Every attempt that is saved, and every exam that begins, asks whom the trail trusts: few entries of a long trail.
CREATE INDEX audit_by_action ON audit (action, id);

-- What a withdrawal erases.
CREATE INDEX attempts_by_study ON attempts (study, participant) WHERE study <> '';

-- What is still to be simulated again: few rows of many.
CREATE INDEX attempts_waiting ON attempts (started_utc, id) WHERE replay = 1;

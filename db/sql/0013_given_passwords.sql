-- 1 = the password was set by somebody else, who knows it: the owner is asked for one of his own.
ALTER TABLE accounts ADD COLUMN password_given {INT64} NOT NULL DEFAULT 0 CHECK (password_given IN (0, 1));

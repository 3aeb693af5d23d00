// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the server asks of an attempt that a station adds or changes, as SQL: a station adds what
// nobody has verified, and what simulating it again gave says somebody who has signed in and may,
// never whose attempt it is. How the functions are set up: db/station_guard_sql.cpp.
#include "db/records.h"
#include "db/station_guard.h"

namespace placode::db {

// Numbers that stand in the text.
static_assert(static_cast<int>(ReplayState::kNotReplayed) == 0 &&
              static_cast<int>(ReplayState::kWaiting) == 1 &&
              static_cast<int>(sim::EndReason::kInterrupted) == 4);

// A change is that of a coordinator who makes an own attempt a participant's
// (db/studies_steps.cpp), or what a replay found. Parts are of the transaction that adds the
// attempt: `need_part` in db/station_guard_reading_sql.cpp.
const char* const kGuardAttempts = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.verifies(of_account BIGINT, of_study TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.trusted() OR CASE WHEN of_study <> '' THEN placode_guard.has_role(14)
        ELSE placode_guard.has_role(10) AND of_account <> placode_guard.me() END;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.verifies_attempt(of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN coalesce((SELECT placode_guard.verifies(a.account_id, a.study) FROM public.attempts a
        WHERE a.id = of_attempt), false);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.watch_attempt() RETURNS TRIGGER
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE waits INT;
BEGIN
    IF placode_guard.trusted() THEN RETURN NEW; END IF;
    waits := CASE WHEN NEW.void_reason = '' AND NEW.end_reason <> 4 THEN 1 ELSE 0 END;
    IF TG_OP = 'INSERT' THEN
        PERFORM placode_guard.insist(NEW.replayed_utc = '' AND NEW.generated_from = 0 AND NEW.replay =
            CASE WHEN NEW.exam_course <> '' OR NEW.study <> '' THEN waits ELSE 0 END);
        -- What ends an exam that was begun is an exam, and so is asked all of this.
        PERFORM placode_guard.insist(NEW.exam_begin = 0 OR NEW.exam_course <> '');
        -- An exam of one's own is the one that was begun here: a proctor's name is anybody's word.
        IF NEW.exam_course <> '' AND NEW.void_reason = '' AND NEW.account_id = placode_guard.me() THEN
            PERFORM placode_guard.insist(EXISTS (SELECT FROM public.exam_begins b
                WHERE b.id = NEW.exam_begin AND b.account_id = NEW.account_id AND b.course_id = NEW.exam_course
                    AND b.stage_id = NEW.exam_stage AND b.task_id = NEW.task_id AND b.seed = NEW.seed
                    AND b.proctor = NEW.proctor AND abs(extract(epoch FROM
                        NEW.started_utc::TIMESTAMPTZ - b.begun_utc::TIMESTAMPTZ)) <= 300 + least(NEW.duration_s, 7200)));
        END IF;
        RETURN NEW;
    END IF;
    PERFORM placode_guard.insist(CASE
        WHEN NEW.study = OLD.study AND NEW.participant = OLD.participant
            THEN placode_guard.verifies(OLD.account_id, OLD.study)
        ELSE OLD.study = '' AND OLD.exam_course = '' AND OLD.account_id = placode_guard.me()
            AND placode_guard.has_role(4) AND NEW.replayed_utc = OLD.replayed_utc AND NEW.read_by = ''
            AND starts_with(NEW.void_reason, OLD.void_reason)
            AND NEW.replay = CASE WHEN OLD.replay = 0 THEN waits ELSE OLD.replay END END);
    RETURN NEW;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_recording() RETURNS TRIGGER
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    -- What a script did, broke off or is void counts for nobody; but it may end an exam that was begun.
    PERFORM placode_guard.insist(placode_guard.trusted() OR (NEW.exam_begin = 0
            AND (NEW.void_reason <> '' OR NEW.end_reason = 4 OR NEW.demonstration = 1))
        OR EXISTS (SELECT FROM public.recordings r WHERE r.attempt_id = NEW.id));
    RETURN NULL;
END $$
--
DROP TRIGGER IF EXISTS watch_attempt ON public.attempts
--
CREATE TRIGGER watch_attempt BEFORE INSERT OR UPDATE ON public.attempts
FOR EACH ROW EXECUTE FUNCTION placode_guard.watch_attempt()
--
DROP TRIGGER IF EXISTS need_recording ON public.attempts
--
CREATE CONSTRAINT TRIGGER need_recording AFTER INSERT ON public.attempts DEFERRABLE INITIALLY DEFERRED
FOR EACH ROW EXECUTE FUNCTION placode_guard.need_recording()
)sql";

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the schema placode_guard about who says something: rows bear the name of whoever
// has signed in, and a signature that of whoever gave the password for it. How they are set up:
// db/station_guard_sql.cpp.
#include "db/station_guard.h"

namespace placode::db {

// `enter` of db/station_guard_sql.cpp notes who has confirmed a password; that is for one
// signature.
const char* const kGuardWords = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.need_own_word(by TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.trusted() OR (placode_guard.me() <> 0
        AND by = 'user ' || placode_guard.me()));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_now(at TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.trusted() OR CASE WHEN at ~ '^[0-9]{4}-[0-9]{2}-[0-9]{2}[T ][0-9]{2}:'
        THEN at::TIMESTAMPTZ BETWEEN clock_timestamp() - INTERVAL '1 minute' AND clock_timestamp() + INTERVAL '1 minute'
        ELSE false END);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_event(what TEXT, by TEXT, as_name TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    IF placode_guard.trusted() THEN RETURN true; END IF;
    PERFORM placode_guard.need(4);
    PERFORM placode_guard.insist(as_name = by);
    IF what <> 'signed' THEN RETURN placode_guard.need_own_word(by); END IF;
    DELETE FROM placode_guard.confirmations c WHERE c.pid = pg_backend_pid() AND by = 'user ' || c.account
        AND c.made > clock_timestamp() - INTERVAL '1 minute';
    RETURN placode_guard.insist(FOUND);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_blank(of_event BIGINT, as_name TEXT, said TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    -- What an erasure takes out, and nothing else. The row is read as it was before the change.
    RETURN placode_guard.need(12) AND placode_guard.insist(placode_guard.trusted() OR EXISTS (SELECT
        FROM public.record_events e WHERE e.id = of_event AND said IN ('', e.remark)
            AND as_name IN (e.by_login, e.by_name)));
END $$
)sql";

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the schema placode_guard by which policies decide what a station sees and adds,
// and the few answers of which the rows themselves stay out of its sight, as SQL. How they are set
// up: db/station_guard_sql.cpp. Policies ask them as `(SELECT placode_guard.me())`, which the
// server computes once for a statement and not for every row.
#include "db/station_guard.h"

namespace placode::db {

// Whose row it is, by the table of db/access.cpp. need_...() are for what is added or changed: they
// refuse where `has_role` and its like only leave rows out.
const char* const kGuardScopes = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.is_in() RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.trusted() OR placode_guard.me() <> 0;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.holder() RETURNS BIGINT
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN coalesce((SELECT s.account FROM placode_guard.sessions s WHERE NOT s.resting AND
        s.token = current_setting('placode.session', true)
        AND s.since > clock_timestamp() - INTERVAL '24 hours'), 0);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.is_demonstration() RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN EXISTS (SELECT FROM public.accounts)
        AND NOT EXISTS (SELECT FROM public.accounts a WHERE a.demonstration = 0);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.is_staff(who BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN EXISTS (SELECT FROM public.accounts a WHERE a.id = who AND (a.roles & 14) <> 0);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.reaches(who BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN who = placode_guard.me()
        OR NOT EXISTS (SELECT FROM public.group_members m WHERE m.account_id = who)
        OR EXISTS (SELECT FROM public.group_members t JOIN public.group_members m ON m.group_id =
            t.group_id WHERE t.account_id = placode_guard.me() AND t.teaches = 1 AND m.account_id = who);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.teaches(which BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN NOT EXISTS (SELECT FROM public.group_members m WHERE m.group_id = which AND m.teaches = 1)
        OR EXISTS (SELECT FROM public.group_members m WHERE m.group_id = which AND m.teaches = 1
            AND m.account_id = placode_guard.me());
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.insist(may BOOLEAN) RETURNS BOOLEAN
LANGUAGE plpgsql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    IF may THEN RETURN true; END IF;
    RAISE EXCEPTION 'you may not do this on the server; sign in again with an account that may';
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_person(everywhere BIGINT, in_reach BIGINT, who BIGINT, own BOOLEAN)
RETURNS BOOLEAN LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.has_role(everywhere) OR (own AND who = placode_guard.me())
        OR (placode_guard.has_role(in_reach) AND placode_guard.reaches(who)));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_group(everywhere BIGINT, in_reach BIGINT, which BIGINT)
RETURNS BOOLEAN LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.has_role(everywhere)
        OR (placode_guard.has_role(in_reach) AND placode_guard.teaches(which)));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_save(who BIGINT, of_study TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(CASE WHEN of_study <> '' THEN placode_guard.has_role(4)
        ELSE placode_guard.has_role(8) OR (who <> 0 AND who = placode_guard.me()) END);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_part(of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    -- Of an attempt that this transaction has added, and of no other: what is kept stays as it was.
    RETURN placode_guard.insist(coalesce((SELECT placode_guard.need_save(a.account_id, a.study)
        AND (placode_guard.trusted() OR a.xmin = pg_current_xact_id()::xid)
        FROM public.attempts a WHERE a.id = of_attempt), false));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_erase(of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.has_role(8) OR (placode_guard.has_role(4) AND EXISTS
        (SELECT FROM public.attempts a WHERE a.id = of_attempt AND a.study <> '')));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.judges(of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.trusted() OR (placode_guard.has_role(2) AND EXISTS (SELECT FROM public.attempts a
        WHERE a.id = of_attempt AND (a.study <> ''
            OR (a.account_id <> placode_guard.me() AND placode_guard.reaches(a.account_id)))));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_remark(author BIGINT, of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.trusted() OR (author = placode_guard.me() AND (
        placode_guard.judges(of_attempt) OR EXISTS (SELECT FROM public.attempts a WHERE a.id = of_attempt
            AND a.study = '' AND a.account_id = author))));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_removal(author BIGINT, of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(author = placode_guard.me() OR placode_guard.judges(of_attempt));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_rating(rater BIGINT, of_attempt BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist((placode_guard.trusted() OR rater = placode_guard.me())
        AND placode_guard.judges(of_attempt));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_rating_part(of_rating BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(coalesce((SELECT placode_guard.need_rating(r.rater_id, r.attempt_id)
        FROM public.attempt_ratings r WHERE r.id = of_rating), false));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need_text(of_kind TEXT, by TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.trusted() OR (placode_guard.me() <> 0
        AND by = 'user ' || placode_guard.me() AND CASE
        WHEN of_kind IN ('task', 'questionnaire', 'course') THEN true  -- Kept at its first use.
        WHEN of_kind IN ('rubric', 'standard') THEN placode_guard.has_role(2)
        ELSE placode_guard.has_role(4) END));
END $$
)sql";

// Single answers about rows that stay out of sight: what signing in needs, whether a recording is
// there already, and of the trail where it ends and whom it trusts.
const char* const kGuardAnswers = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.any_account() RETURNS BOOLEAN
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT EXISTS (SELECT FROM public.accounts)
$$
--
CREATE OR REPLACE FUNCTION placode_guard.account_of(of_login TEXT, only_active BOOLEAN) RETURNS BIGINT
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT coalesce((SELECT a.id FROM public.accounts a JOIN public.persons p ON p.account_id = a.id
        WHERE p.login_key = of_login AND (a.active = 1 OR NOT only_active)), 0)
$$
--
CREATE OR REPLACE FUNCTION placode_guard.named_in(said TEXT)
RETURNS TABLE (account_id BIGINT, login TEXT, display_name TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    -- Nothing but what was said: the one of both names does not tell the other.
    SELECT p.account_id, CASE WHEN strpos(lower(said), lower(p.login)) > 0 THEN p.login ELSE '' END,
        CASE WHEN strpos(lower(said), lower(p.display_name)) > 0 THEN p.display_name ELSE '' END
        FROM public.persons p WHERE placode_guard.is_in() AND length(said) < 20000
            AND (strpos(lower(said), lower(p.login)) > 0 OR strpos(lower(said), lower(p.display_name)) > 0)
$$
--
CREATE OR REPLACE FUNCTION placode_guard.has_pin(who BIGINT) RETURNS BOOLEAN
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT EXISTS (SELECT FROM public.account_pins p WHERE p.account_id = who)
$$
--
CREATE OR REPLACE FUNCTION placode_guard.invitation_by(hash TEXT)
RETURNS TABLE (id BIGINT, roles BIGINT, group_id BIGINT, expires_utc TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT i.id, i.roles, coalesce(i.group_id, 0), i.expires_utc FROM public.invitations i
        WHERE i.code_hash = hash AND i.used_utc = ''
$$
--
CREATE OR REPLACE FUNCTION placode_guard.owner_of_attempt(of_attempt BIGINT)
RETURNS TABLE (account_id BIGINT, study TEXT, participant TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT a.account_id, a.study, a.participant FROM public.attempts a
        WHERE a.id = of_attempt AND placode_guard.is_in()
$$
--
CREATE OR REPLACE FUNCTION placode_guard.attempt_with(of_checksum TEXT) RETURNS TABLE (attempt_id BIGINT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT r.attempt_id FROM public.recordings r WHERE r.checksum = of_checksum AND placode_guard.is_in()
        ORDER BY r.attempt_id
$$
--
CREATE OR REPLACE FUNCTION placode_guard.attempt_ending(hash TEXT, task TEXT, of_seed TEXT) RETURNS TABLE (id BIGINT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT a.id FROM public.attempts a WHERE a.final_hash = hash AND a.task_id = task AND a.seed = of_seed
        AND a.demonstration = 0 AND placode_guard.is_in() ORDER BY a.id
$$
--
CREATE OR REPLACE FUNCTION placode_guard.trail_end() RETURNS TABLE (id BIGINT, chain TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT t.id, t.chain FROM public.audit t ORDER BY t.id DESC LIMIT 1
$$
--
CREATE OR REPLACE FUNCTION placode_guard.trail_chain(entry BIGINT) RETURNS TABLE (chain TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT t.chain FROM public.audit t WHERE t.id = entry
$$
--
CREATE OR REPLACE FUNCTION placode_guard.trail_first()
RETURNS TABLE (id BIGINT, at_utc TEXT, actor TEXT, action TEXT, object TEXT, detail TEXT)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT t.id, t.at_utc, t.actor, t.action, t.object, t.detail FROM public.audit t ORDER BY t.id LIMIT 1
$$
--
DROP FUNCTION IF EXISTS placode_guard.trail_begin(), placode_guard.trail_trust()
--
CREATE OR REPLACE FUNCTION placode_guard.trail_entries(of_trust BOOLEAN)
RETURNS TABLE (id BIGINT, at_utc TEXT, actor TEXT, action TEXT, object TEXT, detail TEXT, chain TEXT, seals TEXT,
    station TEXT, signature TEXT, before TEXT)
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    -- Two questions: one condition for both would have every entry of the trail read.
    IF of_trust THEN
        RETURN QUERY SELECT t.id, t.at_utc, t.actor, t.action, t.object, t.detail, t.chain, t.seals, t.station,
            t.signature, coalesce((SELECT p.chain FROM public.audit p WHERE p.id < t.id ORDER BY p.id DESC LIMIT 1), '')
            FROM public.audit t WHERE t.action = 'station.trust' ORDER BY t.id;
    ELSE
        RETURN QUERY SELECT t.id, t.at_utc, t.actor, t.action, t.object, t.detail, t.chain, t.seals, t.station,
            t.signature, coalesce((SELECT p.chain FROM public.audit p WHERE p.id < t.id ORDER BY p.id DESC LIMIT 1), '')
            FROM public.audit t WHERE t.id > 0 AND t.station <> '' ORDER BY t.id LIMIT 8;
    END IF;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.add_entry(at TEXT, by TEXT, what TEXT, of_object TEXT, with_detail TEXT,
    with_chain TEXT, with_seals TEXT, from_station TEXT, with_signature TEXT) RETURNS BIGINT
LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE made BIGINT;
BEGIN
    -- The first signature of a trail is the one that all trust goes back to: that of whoever makes the first account.
    IF NOT EXISTS (SELECT FROM public.accounts) THEN PERFORM placode_guard.need(0); END IF;
    INSERT INTO public.audit (at_utc, actor, action, object, detail, chain, seals, station, signature)
        VALUES (at, by, what, of_object, with_detail, with_chain, with_seals, from_station, with_signature)
        RETURNING id INTO made;
    RETURN made;
END $$
)sql";

}  // namespace placode::db

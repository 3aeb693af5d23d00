// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the schema placode_guard, as SQL. Each is owned by the owner of the tables, runs
// with that role's rights (SECURITY DEFINER), finds nothing but what it names (search_path), and
// may be called by those in placode_station only. Statements are separated by a line "--".
#include "db/station_guard.h"

namespace placode::db {

// What only these functions read. A channel is a secret that this backend alone was told, for one
// call; a session is who has signed in, by a token that the backend keeps in a setting; a
// confirmation is who has just given their password to this backend without signing in.
const char* const kGuardTables = R"sql(
CREATE SCHEMA IF NOT EXISTS placode_guard
--
CREATE TABLE IF NOT EXISTS placode_guard.channels (
    pid INT PRIMARY KEY, secret BYTEA NOT NULL, made TIMESTAMPTZ NOT NULL)
--
CREATE TABLE IF NOT EXISTS placode_guard.sessions (
    token TEXT PRIMARY KEY, account BIGINT NOT NULL, since TIMESTAMPTZ NOT NULL, resting BOOLEAN NOT NULL)
--
CREATE TABLE IF NOT EXISTS placode_guard.confirmations (
    pid INT PRIMARY KEY, account BIGINT NOT NULL, made TIMESTAMPTZ NOT NULL)
--
CREATE TABLE IF NOT EXISTS placode_guard.salt_key (id INT PRIMARY KEY CHECK (id = 1), key BYTEA NOT NULL)
--
INSERT INTO placode_guard.salt_key VALUES
    (1, sha256(uuid_send(gen_random_uuid()) || uuid_send(gen_random_uuid()))) ON CONFLICT DO NOTHING
)sql";

// Who has signed in. `session_user` is the log-in itself: SET ROLE does not change it. In PL/pgSQL,
// which plans a question once for a connection: policies ask these at every statement.
const char* const kGuardIdentity = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.trusted() RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN EXISTS (SELECT FROM pg_roles r WHERE r.rolname = 'placode_service'  -- There may be none.
        AND pg_has_role(session_user, r.oid, 'MEMBER')) OR EXISTS (SELECT FROM pg_class c
        WHERE c.oid = 'public.accounts'::regclass AND pg_has_role(session_user, c.relowner, 'MEMBER'));
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.me() RETURNS BIGINT
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN coalesce((SELECT s.account FROM placode_guard.sessions s JOIN public.accounts a
        ON a.id = s.account WHERE s.token = current_setting('placode.session', true) AND a.active = 1
        AND NOT s.resting AND s.since > clock_timestamp() - INTERVAL '24 hours'), 0);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.has_role(mask BIGINT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN EXISTS (SELECT FROM placode_guard.sessions s JOIN public.accounts a ON a.id = s.account
        WHERE s.token = current_setting('placode.session', true) AND a.active = 1 AND (a.roles & mask) <> 0
        AND NOT s.resting AND s.since > clock_timestamp() - INTERVAL '24 hours') OR placode_guard.trusted();
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.need(mask BIGINT, own BIGINT DEFAULT 0) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    IF placode_guard.has_role(mask) OR (own <> 0 AND own = placode_guard.me()) THEN RETURN true; END IF;
    RAISE EXCEPTION 'you may not do this on the server; sign in again with an account that may';
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.random_token() RETURNS BYTEA
LANGUAGE sql VOLATILE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT sha256(uuid_send(gen_random_uuid()) || uuid_send(gen_random_uuid()))
$$
--
CREATE OR REPLACE FUNCTION placode_guard.begin_session(who BIGINT, at TIMESTAMPTZ) RETURNS VOID
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE fresh TEXT := encode(placode_guard.random_token(), 'hex');
BEGIN
    DELETE FROM placode_guard.sessions WHERE token IN (SELECT token FROM placode_guard.sessions
        WHERE since < clock_timestamp() - INTERVAL '24 hours' FOR UPDATE SKIP LOCKED);
    DELETE FROM placode_guard.sessions WHERE token = current_setting('placode.session', true) AND NOT resting;
    INSERT INTO placode_guard.sessions VALUES (fresh, who, at, false);
    PERFORM set_config('placode.session', fresh, false);
END $$
)sql";

// Nothing secret is part of a statement: those of the same log-in see each other's statements in
// pg_stat_activity. A proof is SHA-256(secret of the channel, what is proved); what is handed over
// is masked with a stream of the channel's secret.
const char* const kGuardChannel = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.open_channel() RETURNS TEXT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE fresh BYTEA := placode_guard.random_token();
BEGIN
    DELETE FROM placode_guard.channels WHERE pid IN (SELECT pid FROM placode_guard.channels
        WHERE made < clock_timestamp() - INTERVAL '10 minutes' FOR UPDATE SKIP LOCKED);
    INSERT INTO placode_guard.channels VALUES (pg_backend_pid(), fresh, clock_timestamp())
        ON CONFLICT (pid) DO UPDATE SET secret = excluded.secret, made = excluded.made;
    RETURN encode(fresh, 'hex');
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.take_channel() RETURNS BYTEA
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE found_secret BYTEA;
BEGIN
    DELETE FROM placode_guard.channels WHERE pid = pg_backend_pid()
        AND made > clock_timestamp() - INTERVAL '1 minute' RETURNING secret INTO found_secret;
    IF found_secret IS NULL THEN RAISE EXCEPTION 'you may not do this without a channel'; END IF;
    RETURN found_secret;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.proves(secret BYTEA, what TEXT, proof TEXT) RETURNS BOOLEAN
LANGUAGE sql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT coalesce(what <> '' AND encode(sha256(secret || convert_to(what, 'UTF8')), 'hex') = proof, false)
$$
--
CREATE OR REPLACE FUNCTION placode_guard.unmasked(secret BYTEA, label INT, masked TEXT) RETURNS TEXT
LANGUAGE plpgsql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE bytes BYTEA := decode(masked, 'hex'); pad BYTEA;
BEGIN
    FOR i IN 0..length(bytes) - 1 LOOP
        IF i % 32 = 0 THEN pad := sha256(secret || int4send(label) || int4send(i / 32)); END IF;
        bytes := set_byte(bytes, i, get_byte(bytes, i) # get_byte(pad, i % 32));
    END LOOP;
    RETURN convert_from(bytes, 'UTF8');
END $$
)sql";

const char* const kGuardSignIn = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.prefix_of(hash TEXT) RETURNS TEXT
LANGUAGE sql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT substring(hash FROM '^(\$argon2id\$v=19\$m=[0-9]+,t=[0-9]+,p=1\$[A-Za-z0-9+/]+\$)')
$$
--
CREATE OR REPLACE FUNCTION placode_guard.salt_of(of_login TEXT) RETURNS TEXT
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT coalesce((SELECT placode_guard.prefix_of(a.password_hash) FROM public.accounts a
        JOIN public.persons p ON p.account_id = a.id WHERE p.login_key = of_login),
        (SELECT '$argon2id$v=19$m=65536,t=2,p=1$' || rtrim(encode(substr(sha256(k.key ||
        convert_to(of_login, 'UTF8')), 1, 16), 'base64'), '=') || '$' FROM placode_guard.salt_key k))
$$
--
DROP FUNCTION IF EXISTS placode_guard.enter(TEXT, TEXT, BOOLEAN)
--
CREATE FUNCTION placode_guard.enter(of_login TEXT, proof TEXT, becomes BOOLEAN)
RETURNS TABLE (id BIGINT, login TEXT, display_name TEXT, roles BIGINT, active BIGINT, demonstration BIGINT,
    created_utc TEXT, password_given BIGINT)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel(); who RECORD;
BEGIN
    SELECT a.id, a.password_hash, a.active INTO who FROM public.accounts a JOIN public.persons p
        ON p.account_id = a.id WHERE p.login_key = of_login;
    IF NOT FOUND OR NOT placode_guard.proves(secret, who.password_hash, proof) THEN RETURN; END IF;
    IF becomes AND who.active = 1 THEN
        PERFORM placode_guard.begin_session(who.id, clock_timestamp());
    ELSIF who.active = 1 THEN
        DELETE FROM placode_guard.confirmations WHERE pid IN (SELECT c.pid FROM placode_guard.confirmations c
            WHERE c.made < clock_timestamp() - INTERVAL '10 minutes' FOR UPDATE SKIP LOCKED);
        INSERT INTO placode_guard.confirmations VALUES (pg_backend_pid(), who.id, clock_timestamp())
            ON CONFLICT (pid) DO UPDATE SET account = excluded.account, made = excluded.made;
    END IF;
    -- Also of an account that is closed, and of a proctor: whoever has the password may know whose it is.
    RETURN QUERY SELECT a.id, p.login, p.display_name, a.roles, a.active, a.demonstration, a.created_utc,
        a.password_given FROM public.accounts a JOIN public.persons p ON p.account_id = a.id WHERE a.id = who.id;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.resume(who BIGINT, proof TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel(); begun TIMESTAMPTZ;
BEGIN
    SELECT s.since INTO begun FROM placode_guard.sessions s WHERE s.account = who AND NOT s.resting
        AND s.since > clock_timestamp() - INTERVAL '24 hours' AND placode_guard.proves(secret, s.token, proof);
    IF begun IS NULL THEN RETURN false; END IF;
    PERFORM placode_guard.begin_session(who, begun);
    RETURN true;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.leave(comes_back BOOLEAN) RETURNS VOID
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    UPDATE placode_guard.sessions SET resting = true
        WHERE token = current_setting('placode.session', true) AND comes_back;
    DELETE FROM placode_guard.sessions
        WHERE token = current_setting('placode.session', true) AND NOT comes_back;
    PERFORM set_config('placode.session', '', false);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.was_here(secret BYTEA, who BIGINT, ticket TEXT) RETURNS BOOLEAN
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT placode_guard.trusted() OR EXISTS (SELECT FROM placode_guard.sessions s WHERE s.account = who
        AND s.since > clock_timestamp() - INTERVAL '12 hours' AND placode_guard.proves(secret, s.token, ticket))
$$
--
CREATE OR REPLACE FUNCTION placode_guard.pin_salt_of(who BIGINT, ticket TEXT) RETURNS TEXT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel(); prefix TEXT;
BEGIN
    IF placode_guard.was_here(secret, who, ticket) THEN
        SELECT placode_guard.prefix_of(pin_hash) INTO prefix FROM public.account_pins WHERE account_id = who;
    END IF;
    RETURN coalesce(prefix, '');
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.enter_by_pin(who BIGINT, ticket TEXT, proof TEXT, most INT) RETURNS BIGINT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel(); pin RECORD; begun TIMESTAMPTZ;
BEGIN
    IF NOT placode_guard.was_here(secret, who, ticket) THEN RETURN 0; END IF;
    SELECT p.pin_hash, p.failures, a.active INTO pin FROM public.account_pins p JOIN public.accounts a
        ON a.id = p.account_id WHERE p.account_id = who FOR UPDATE OF p;
    IF NOT FOUND OR pin.failures >= least(most, 3) THEN RETURN 0; END IF;
    IF NOT placode_guard.proves(secret, pin.pin_hash, proof) THEN
        UPDATE public.account_pins SET failures = failures + 1 WHERE account_id = who;
        RETURN 0;
    END IF;
    UPDATE public.account_pins SET failures = 0 WHERE account_id = who;
    IF pin.active = 1 THEN
        SELECT s.since INTO begun FROM placode_guard.sessions s WHERE s.account = who
            AND placode_guard.proves(secret, s.token, ticket);
        PERFORM placode_guard.begin_session(who, coalesce(begun, clock_timestamp()));
    END IF;
    RETURN who;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.drop_worn_pin(who BIGINT) RETURNS VOID
LANGUAGE sql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    DELETE FROM public.account_pins WHERE account_id = who AND failures >= 3
$$
)sql";

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the schema placode_guard that make, change and seal accounts, as SQL. How they
// are set up: db/station_guard_sql.cpp.
#include "db/station_guard.h"

namespace placode::db {

// BLAKE2b-256 (RFC 7693), which PostgreSQL does not have: the seals of accounts are of it, and a
// station may not read what it is of. Words of 64 bits are kept as halves, because a sum of
// BIGINTs does not wrap around.
const char* const kGuardChecksum = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.checksum(message BYTEA) RETURNS TEXT
LANGUAGE plpgsql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE
    ones CONSTANT BIGINT := 4294967295;
    iv_high CONSTANT BIGINT[] := ARRAY[1779033703, 3144134277, 1013904242, 2773480762, 1359893119,
        2600822924, 528734635, 1541459225];
    iv_low CONSTANT BIGINT[] := ARRAY[4089235720, 2227873595, 4271175723, 1595750129, 2917565137,
        725511199, 4215389547, 327033209];
    sigma CONSTANT INT[] := ARRAY[
        0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15, 14,10,4,8,9,15,13,6,1,12,0,2,11,7,5,3,
        11,8,12,0,5,2,15,13,10,14,3,6,7,1,9,4, 7,9,3,1,13,12,11,14,2,6,5,10,4,0,15,8,
        9,0,5,7,2,4,10,15,14,1,11,12,6,8,3,13, 2,12,6,10,0,11,8,3,4,13,7,5,15,14,1,9,
        12,5,1,15,14,13,4,10,0,7,6,3,9,2,8,11, 13,11,7,14,12,1,3,9,5,0,15,4,8,6,2,10,
        6,15,14,9,11,3,0,8,12,2,13,7,1,4,10,5, 10,2,8,4,7,6,1,5,15,11,9,14,3,12,13,0];
    places CONSTANT INT[] := ARRAY[1,5,9,13, 2,6,10,14, 3,7,11,15, 4,8,12,16,
        1,6,11,16, 2,7,12,13, 3,8,9,14, 4,5,10,15];
    size CONSTANT INT := length(message);
    blocks CONSTANT INT := greatest(1, (length(message) + 127) / 128);
    padded CONSTANT BYTEA := message || decode(repeat('00', blocks * 128 - length(message)), 'hex');
    hh BIGINT[] := iv_high; hl BIGINT[] := iv_low;
    vh BIGINT[]; vl BIGINT[]; mh BIGINT[]; ml BIGINT[];
    ah BIGINT; al BIGINT; bh BIGINT; bl BIGINT; ch BIGINT; cl BIGINT; dh BIGINT; dl BIGINT;
    xh BIGINT; xl BIGINT; count INT; word INT; at INT; a INT; b INT; c INT; d INT; result BYTEA := '';
BEGIN
    hl[1] := hl[1] # 16842784;  -- 0x01010020: 32 bytes, no key, one leaf
    FOR block IN 1..blocks LOOP
        FOR i IN 0..15 LOOP
            at := (block - 1) * 128 + i * 8;
            ml[i] := get_byte(padded, at) + (get_byte(padded, at + 1)::BIGINT << 8)
                + (get_byte(padded, at + 2)::BIGINT << 16) + (get_byte(padded, at + 3)::BIGINT << 24);
            mh[i] := get_byte(padded, at + 4) + (get_byte(padded, at + 5)::BIGINT << 8)
                + (get_byte(padded, at + 6)::BIGINT << 16) + (get_byte(padded, at + 7)::BIGINT << 24);
        END LOOP;
        vh := hh || iv_high; vl := hl || iv_low;
        count := least(block * 128, size);
        vl[13] := vl[13] # count;
        IF block = blocks THEN vh[15] := vh[15] # ones; vl[15] := vl[15] # ones; END IF;
        FOR round IN 0..11 LOOP
            FOR g IN 0..7 LOOP
                a := places[g * 4 + 1]; b := places[g * 4 + 2];
                c := places[g * 4 + 3]; d := places[g * 4 + 4];
                ah := vh[a]; al := vl[a]; bh := vh[b]; bl := vl[b];
                ch := vh[c]; cl := vl[c]; dh := vh[d]; dl := vl[d];
                word := sigma[(round % 10) * 16 + g * 2 + 1];
                al := al + bl + ml[word]; ah := (ah + bh + mh[word] + (al >> 32)) & ones; al := al & ones;
                xh := dl # al; dl := dh # ah; dh := xh;
                cl := cl + dl; ch := (ch + dh + (cl >> 32)) & ones; cl := cl & ones;
                xh := bh # ch; xl := bl # cl;
                bh := ((xh >> 24) | (xl << 8)) & ones; bl := ((xl >> 24) | (xh << 8)) & ones;
                word := sigma[(round % 10) * 16 + g * 2 + 2];
                al := al + bl + ml[word]; ah := (ah + bh + mh[word] + (al >> 32)) & ones; al := al & ones;
                xh := dh # ah; xl := dl # al;
                dh := ((xh >> 16) | (xl << 16)) & ones; dl := ((xl >> 16) | (xh << 16)) & ones;
                cl := cl + dl; ch := (ch + dh + (cl >> 32)) & ones; cl := cl & ones;
                xh := bh # ch; xl := bl # cl;
                bh := ((xh << 1) | (xl >> 31)) & ones; bl := ((xl << 1) | (xh >> 31)) & ones;
                vh[a] := ah; vl[a] := al; vh[b] := bh; vl[b] := bl;
                vh[c] := ch; vl[c] := cl; vh[d] := dh; vl[d] := dl;
            END LOOP;
        END LOOP;
        FOR i IN 1..8 LOOP
            hh[i] := hh[i] # vh[i] # vh[i + 8]; hl[i] := hl[i] # vl[i] # vl[i + 8];
        END LOOP;
    END LOOP;
    FOR i IN 1..4 LOOP
        FOR k IN 0..3 LOOP result := result || set_byte('\x00', 0, ((hl[i] >> (8 * k)) & 255)::INT); END LOOP;
        FOR k IN 0..3 LOOP result := result || set_byte('\x00', 0, ((hh[i] >> (8 * k)) & 255)::INT); END LOOP;
    END LOOP;
    RETURN encode(result, 'hex');
END $$
)sql";

// What changes accounts. The masked values are hashes of passwords and the code of an invitation.
const char* const kGuardAccounts = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.insert_account(hash TEXT, with_roles BIGINT, demo BIGINT, given BIGINT,
    at TEXT, as_login TEXT, as_key TEXT, as_name TEXT) RETURNS BIGINT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE made BIGINT;
BEGIN
    INSERT INTO public.accounts (password_hash, roles, active, demonstration, created_utc, password_given)
        VALUES (hash, with_roles, 1, demo, at, given) RETURNING id INTO made;
    INSERT INTO public.persons (account_id, login, login_key, display_name)
        VALUES (made, as_login, as_key, as_name);
    RETURN made;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.add_account(masked TEXT, with_roles BIGINT, demo BIGINT, given BIGINT,
    at TEXT, as_login TEXT, as_key TEXT, as_name TEXT) RETURNS BIGINT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel();
BEGIN
    LOCK TABLE public.accounts IN SHARE ROW EXCLUSIVE MODE;
    -- The first account of a store is its administrator's, who is there before anybody can sign in.
    IF (with_roles & 8) = 0 OR EXISTS (SELECT FROM public.accounts) THEN
        PERFORM placode_guard.need(8);
    END IF;
    RETURN placode_guard.insert_account(placode_guard.unmasked(secret, 1, masked), with_roles, demo, given, at,
        as_login, as_key, as_name);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.accept_invitation(masked_code TEXT, masked TEXT, demo BIGINT, at TEXT,
    as_login TEXT, as_key TEXT, as_name TEXT) RETURNS BIGINT
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel(); invited RECORD; made BIGINT;
BEGIN
    SELECT * INTO invited FROM public.invitations WHERE used_utc = '' AND code_hash =
        placode_guard.checksum(convert_to(placode_guard.unmasked(secret, 2, masked_code), 'UTF8')) FOR UPDATE;
    -- The last day is a day to its end. Who is trusted has looked at the clock already.
    IF NOT FOUND OR NOT (placode_guard.trusted() OR clock_timestamp() < (invited.expires_utc::TIMESTAMP AT TIME ZONE
        'UTC') + CASE WHEN length(invited.expires_utc) = 10 THEN INTERVAL '1 day' ELSE INTERVAL '0' END) THEN
        RAISE EXCEPTION 'you may not take up this invitation; ask for another one';
    END IF;
    made := placode_guard.insert_account(placode_guard.unmasked(secret, 1, masked), invited.roles, demo, 0, at,
        as_login, as_key, as_name);
    IF invited.group_id IS NOT NULL THEN
        INSERT INTO public.group_members (group_id, account_id, teaches) VALUES (invited.group_id, made, 0);
    END IF;
    UPDATE public.invitations SET used_utc = at, note = '' WHERE id = invited.id;
    RETURN made;
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.set_password(who BIGINT, masked TEXT, given BIGINT) RETURNS VOID
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel();
BEGIN
    PERFORM placode_guard.need(8, who);
    UPDATE public.accounts SET password_hash = placode_guard.unmasked(secret, 1, masked), password_given = given
        WHERE id = who;
    DELETE FROM placode_guard.sessions WHERE account = who AND token IS DISTINCT FROM current_setting('placode.session', true);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.set_pin(who BIGINT, masked TEXT) RETURNS VOID
LANGUAGE plpgsql SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
DECLARE secret BYTEA := placode_guard.take_channel();
BEGIN
    PERFORM placode_guard.need(0, who);
    INSERT INTO public.account_pins (account_id, pin_hash, failures)
        VALUES (who, placode_guard.unmasked(secret, 1, masked), 0);
END $$
--
CREATE OR REPLACE FUNCTION placode_guard.sealed_text(value TEXT) RETURNS TEXT
LANGUAGE sql IMMUTABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT octet_length(value) || ':' || value || ';'
$$
--
CREATE OR REPLACE FUNCTION placode_guard.seal_of_account(who BIGINT) RETURNS TEXT
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT placode_guard.checksum(convert_to(placode_guard.sealed_text(password_hash)
        || placode_guard.sealed_text(roles::TEXT) || placode_guard.sealed_text(active::TEXT)
        || placode_guard.sealed_text(demonstration::TEXT) || placode_guard.sealed_text(created_utc)
        || placode_guard.sealed_text(password_given::TEXT) || E'\n', 'UTF8')) FROM public.accounts WHERE id = who
$$
--
CREATE OR REPLACE FUNCTION placode_guard.seal_of_pin(who BIGINT) RETURNS TEXT
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
    SELECT placode_guard.checksum(convert_to(placode_guard.sealed_text(pin_hash) || E'\n', 'UTF8'))
        FROM public.account_pins WHERE account_id = who
$$
)sql";

}  // namespace placode::db

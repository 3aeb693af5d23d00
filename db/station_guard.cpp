// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/station_guard.h"

#include <algorithm>
#include <array>

#include "db/packing.h"
#include "db/seal_kinds.h"
#include "db/station_role.h"

namespace placode::db {
namespace {

// Sums of the bits of db/records.h, Role, as SQL.
constexpr const char* kAdministrator = "placode_guard.need(8)";
constexpr const char* kOwnOrAdministrator = "placode_guard.need(8, account_id)";
constexpr const char* kEducator = "placode_guard.need(2)";
constexpr const char* kTeachesOrAdministers = "placode_guard.need(10)";
constexpr const char* kCoordinator = "placode_guard.need(4)";
constexpr const char* kStaff = "placode_guard.need(14)";
constexpr const char* kNever = "false";
// With the groups that somebody teaches.
constexpr const char* kTeachesTheTarget =
    "CASE WHEN group_id IS NULL THEN placode_guard.need_person(0, 2, account_id, false) ELSE "
    "placode_guard.need_group(0, 2, group_id) END";
// In the name of whoever has signed in.
constexpr const char* kGrants =
    "placode_guard.need_person(0, 2, account_id, false) AND "
    "placode_guard.need_own_word(granted_by)";
constexpr const char* kAssigns =
    "CASE WHEN group_id IS NULL THEN placode_guard.need_person(0, 2, account_id, false) ELSE "
    "placode_guard.need_group(0, 2, group_id) END AND placode_guard.need_own_word(assigned_by)";
constexpr const char* kCertifies =
    "placode_guard.need_person(0, 2, account_id, true) AND placode_guard.need_own_word(issued_by) "
    "AND placode_guard.need_now(issued_utc)";
constexpr const char* kWithdraws =
    "placode_guard.need(4) AND placode_guard.need_own_word(withdrawn_by)";
constexpr const char* kCorrects =
    "placode_guard.need(4) AND placode_guard.need_own_word(corrected_by)";
constexpr const char* kChooses = "placode_guard.need(4) AND placode_guard.need_own_word(chosen_by)";
constexpr const char* kEnters = "placode_guard.need(4) AND placode_guard.need_own_word(entered_by)";
constexpr const char* kSupersedes =
    "placode_guard.need(4) AND placode_guard.need_own_word(superseded_by)";
constexpr const char* kNotes = "placode_guard.need(4) AND placode_guard.need_own_word(noted_by)";
constexpr const char* kInvites =
    "placode_guard.need(8) AND placode_guard.need_own_word(invited_by)";
constexpr const char* kTrusts = "placode_guard.need(10) AND placode_guard.need_own_word(added_by)";
constexpr const char* kKeepsNorms =
    "placode_guard.need(2) AND placode_guard.need_own_word(added_by)";
constexpr const char* kScoresAgain =
    "placode_guard.need(2) AND placode_guard.need_own_word(scored_by)";
constexpr const char* kKeepsTheGroup =
    "placode_guard.need_group(8, 2, group_id) AND placode_guard.need_person(8, 2, account_id, "
    "false)";
constexpr const char* kSavesThePart = "placode_guard.need_part(attempt_id)";
constexpr const char* kErasesThePart = "placode_guard.need_erase(attempt_id)";
constexpr const char* kErasesTheScore =
    "placode_guard.need_erase((SELECT s.attempt_id FROM public.attempt_scores s WHERE s.id = "
    "score_id))";

// What is seen: rows are left out, nothing is refused. Each is asked once for a statement.
constexpr const char* kWhoIsIn = "(SELECT placode_guard.is_in())";
constexpr const char* kSeesAdministrator = "(SELECT placode_guard.has_role(8))";
constexpr const char* kSeesStudies = "(SELECT placode_guard.has_role(12))";
constexpr const char* kSeesSteps = "(SELECT placode_guard.has_role(14))";
constexpr const char* kSeesOwnOrAdministrator =
    "(SELECT placode_guard.has_role(8)) OR account_id = (SELECT placode_guard.me())";
constexpr const char* kSeesOwnOrTeaches =
    "(SELECT placode_guard.has_role(10)) OR account_id = (SELECT placode_guard.me())";
constexpr const char* kSeesAccounts =
    "(SELECT placode_guard.is_in()) OR id = (SELECT placode_guard.holder()) OR (SELECT "
    "placode_guard.is_demonstration())";
constexpr const char* kSeesPersons =
    "(SELECT placode_guard.has_role(10)) OR account_id = (SELECT placode_guard.holder()) OR "
    "((SELECT placode_guard.is_in()) AND placode_guard.is_staff(account_id)) OR (SELECT "
    "placode_guard.is_demonstration())";
constexpr const char* kSeesGroups =
    "(SELECT placode_guard.has_role(10)) OR EXISTS (SELECT FROM public.group_members m WHERE "
    "m.group_id = training_groups.id AND m.account_id = (SELECT placode_guard.me()))";
constexpr const char* kSeesAssignments =
    "(SELECT placode_guard.has_role(10)) OR account_id = (SELECT placode_guard.me()) OR group_id "
    "IN (SELECT m.group_id FROM public.group_members m WHERE m.account_id = (SELECT "
    "placode_guard.me()))";
constexpr const char* kSeesAttempts =
    "(SELECT placode_guard.has_role(10)) OR (study = '' AND account_id = (SELECT "
    "placode_guard.me())) OR (study <> '' AND (SELECT placode_guard.has_role(4)))";
// A part of what is seen: the policy of the other table applies within.
constexpr const char* kSeesPart =
    "(SELECT placode_guard.has_role(10)) OR EXISTS (SELECT FROM public.attempts a WHERE a.id = "
    "attempt_id)";
constexpr const char* kSeesScorePart =
    "(SELECT placode_guard.has_role(10)) OR EXISTS (SELECT FROM public.attempt_scores s WHERE s.id "
    "= score_id)";
constexpr const char* kSeesRatingPart =
    "(SELECT placode_guard.has_role(10)) OR EXISTS (SELECT FROM public.attempt_ratings r WHERE "
    "r.id = rating_id)";

/// What has to hold, as SQL over the row, for a station that sees, adds, changes or removes one. It
/// never widens the rights of db/station_role.cpp. The table is that of db/access.cpp; where adding
/// or changing stands for everybody who sees the row, the condition is that of seeing it, because
/// the server asks for sight only where a statement names a column.
struct TableRule {
    const char* table;
    const char* sees;
    const char* adds;
    const char* changes;
    const char* removes;
    const char* changed = nullptr;  ///< Of the row as it is then; nullptr: as `changes`.
};

constexpr std::array kRules{
    TableRule{"accounts", kSeesAccounts, kAdministrator, kAdministrator, kAdministrator},
    TableRule{"persons", kSeesPersons, kAdministrator, kAdministrator, kAdministrator},
    TableRule{"account_pins", kSeesOwnOrAdministrator, kAdministrator, kAdministrator,
              kOwnOrAdministrator},
    TableRule{"invitations", kSeesAdministrator, kInvites, kAdministrator, kAdministrator},
    TableRule{"erasure_requests", kSeesOwnOrAdministrator, kOwnOrAdministrator, kAdministrator,
              kAdministrator},
    TableRule{"training_groups", kSeesGroups, kTeachesOrAdministers, kAdministrator,
              kAdministrator},
    TableRule{"group_members", kSeesOwnOrTeaches, kKeepsTheGroup, kKeepsTheGroup, kKeepsTheGroup},
    TableRule{"course_assignments", kSeesAssignments, kAssigns, kTeachesTheTarget, kAdministrator},
    TableRule{"course_grants", kSeesOwnOrTeaches, kGrants, kAdministrator, kAdministrator},
    TableRule{"exam_begins", kSeesOwnOrTeaches, "placode_guard.need_begin(account_id, begun_utc)",
              kNever, kAdministrator},
    TableRule{"certificates", kSeesOwnOrTeaches, kCertifies, kAdministrator, kAdministrator},
    TableRule{"trusted_centres", kWhoIsIn, kTrusts, kAdministrator, kAdministrator},
    TableRule{"centre_key", kWhoIsIn, kTeachesOrAdministers, kTeachesOrAdministers, kAdministrator},
    TableRule{"norm_packs", kWhoIsIn, kKeepsNorms, kEducator, kAdministrator},
    TableRule{"definitions", kWhoIsIn, "placode_guard.need_text(kind, published_by)", kNever,
              kNever},
    TableRule{"audit", kSeesAdministrator, kNever, kNever, kNever},
    TableRule{"attempts", kSeesAttempts, "placode_guard.need_save(account_id, study)",
              kSeesAttempts, "placode_guard.need_erase(id)"},
    TableRule{"attempt_metrics", kSeesPart, kSavesThePart, kNever, kErasesThePart},
    TableRule{"attempt_reasons", kSeesPart, kSavesThePart, kNever, kErasesThePart},
    TableRule{"attempt_events", kSeesPart, kSavesThePart, kNever, kErasesThePart},
    TableRule{"recordings", kSeesPart, kSavesThePart, kNever, kErasesThePart},
    TableRule{"attempt_scores", kSeesPart, kScoresAgain, kNever, kErasesThePart},
    TableRule{"attempt_score_metrics", kSeesScorePart, kEducator, kNever, kErasesTheScore},
    TableRule{"attempt_score_reasons", kSeesScorePart, kEducator, kNever, kErasesTheScore},
    TableRule{"attempt_comments", kSeesPart, "placode_guard.need_remark(author_id, attempt_id)",
              "placode_guard.need_removal(author_id, attempt_id)", kErasesThePart},
    TableRule{"attempt_ratings", kSeesPart, "placode_guard.need_rating(rater_id, attempt_id)",
              kNever, kErasesThePart},
    TableRule{"attempt_rating_items", kSeesRatingPart, "placode_guard.need_rating_part(rating_id)",
              kNever, kNever},
    TableRule{"answers", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"answer_items", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"answer_changes", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"study_steps", kSeesSteps, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"participants", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"participant_states", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"participant_devices", kSeesStudies, kChooses, kCoordinator, kCoordinator, kChooses},
    TableRule{"withdrawals", kSeesStudies, kWithdraws, kCoordinator, kCoordinator, kWithdraws},
    TableRule{"consent_signatures", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"answer_corrections", kSeesStudies, kCorrects, kCoordinator, kCoordinator},
    TableRule{"second_entries", kSeesStudies, kEnters, kCoordinator, kCoordinator},
    TableRule{"second_entry_items", kSeesStudies, kCoordinator, kCoordinator, kCoordinator},
    TableRule{"superseded_steps", kSeesSteps, kSupersedes, kCoordinator, kCoordinator},
    TableRule{"step_notes", kSeesStudies, kNotes, kCoordinator, kCoordinator},
    TableRule{"record_events", kSeesStudies, "placode_guard.need_event(event, by_login, by_name)",
              "placode_guard.need_blank(id, by_name, remark)", kAdministrator},
    TableRule{"study_allocations", kSeesStudies, kStaff, kStaff, kAdministrator},
};
constexpr int kPoliciesOfATable = 5;
constexpr int kTriggersOfAttempts = 2;

/// What stations call, and what policies ask in a station's name; all other functions only these
/// call.
constexpr const char* kCalled =
    "'open_channel', 'salt_of', 'enter', 'resume', 'leave', 'pin_salt_of', 'enter_by_pin', "
    "'drop_worn_pin', 'add_account', 'accept_invitation', 'set_password', 'set_pin', "
    "'seal_of_account', 'seal_of_pin', 'seal_parts', 'me', 'need', 'version', 'is_in', 'holder', "
    "'has_role', 'is_staff', 'is_demonstration', 'need_person', 'need_group', 'need_save', "
    "'need_part', 'need_erase', 'need_remark', 'need_removal', 'need_rating', 'need_rating_part', "
    "'need_text', 'need_begin', 'need_own_word', 'need_now', 'need_event', 'need_blank', "
    "'any_account', 'account_of', 'named_in', 'has_pin', 'invitation_by', 'owner_of_attempt', "
    "'attempt_with', "
    "'attempt_ending', 'verifies', 'verifies_attempt', 'trail_end', 'trail_chain', 'trail_first', "
    "'trail_entries', "
    "'add_entry'";

void add_statements(std::vector<std::string>& sql, const std::string& text) {
    constexpr std::string_view kBetween = "\n--\n";
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find(kBetween, begin), text.size());
        sql.push_back(text.substr(begin, end - begin));
        begin = end + kBetween.size();
    }
}

/// Policies of a table, made anew. The owner's own keeps the functions and references working where
/// the owner is no superuser of the server: forced security holds for owners, too.
std::string rule_statement(const TableRule& rule) {
    const std::string on = std::string(" ON public.") + rule.table;
    std::string sql = "DO $$ DECLARE owner TEXT; BEGIN\n";
    for (const char* policy :
         {"owner_all", "station_reads", "station_adds", "station_changes", "station_removes"})
        sql += std::string("    DROP POLICY IF EXISTS ") + policy + on + ";\n";
    sql += std::string(
               "    SELECT tableowner INTO owner FROM pg_tables WHERE schemaname = "
               "'public' AND tablename = '") +
           rule.table +
           "';\n    IF owner IS NULL THEN RETURN; END IF;  -- a later version has dropped it\n    "
           "EXECUTE format('CREATE POLICY owner_all" +
           on + " TO %I USING (true) WITH CHECK (true)', owner);\n";
    const std::string to = std::string(" TO ") + kStationRole;
    sql += "    CREATE POLICY station_reads" + on + " FOR SELECT" + to + " USING (" + rule.sees +
           ");\n";
    sql += "    CREATE POLICY station_adds" + on + " FOR INSERT" + to + " WITH CHECK (" +
           rule.adds + ");\n";
    sql += "    CREATE POLICY station_changes" + on + " FOR UPDATE" + to + " USING (" +
           rule.changes + ")" +
           (rule.changed != nullptr ? std::string(" WITH CHECK (") + rule.changed + ")" : "") +
           ";\n";
    sql += "    CREATE POLICY station_removes" + on + " FOR DELETE" + to + " USING (" +
           rule.removes + ");\n";
    return sql + "    ALTER TABLE public." + rule.table +
           " ENABLE ROW LEVEL SECURITY, FORCE ROW LEVEL SECURITY;\nEND $$";
}

constexpr std::array<std::string_view, 3> kSealedByServer{"user", "group", "invitation"};

/// The columns of a list, "a, b", as the texts that db/seals.cpp seals them as.
std::string sealed_columns(std::string_view list) {
    std::string sql;
    for (size_t begin = 0; begin < list.size();) {
        const size_t end = std::min(list.find(", ", begin), list.size());
        sql += (sql.empty() ? "" : " || ") + std::string("placode_guard.sealed_text(coalesce((") +
               std::string(list.substr(begin, end - begin)) + ")::TEXT, ''))";
        begin = end + 2;
    }
    return sql;
}

/// placode_guard.seal_parts(kind, id): a line for each part of the object that has rows, as
/// db/seals.cpp makes it; empty: there is no such object.
std::string seal_statement() {
    std::string sql =
        "CREATE OR REPLACE FUNCTION placode_guard.seal_parts(of_kind TEXT, of_id BIGINT) RETURNS "
        "TEXT\nLANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS "
        "$$\nDECLARE rows TEXT; parts TEXT := '';\nBEGIN\n";
    for (const SealKind& kind : seal_kinds()) {
        if (!server_seals(kind.name)) continue;
        sql += "    IF of_kind = '" + std::string(kind.name) + "' THEN\n";
        for (size_t number = 0; number < kind.parts.size(); ++number) {
            const SealPart& part = kind.parts[number];
            const std::string order(part.order.front());
            sql += "        SELECT string_agg(" +
                   (order.empty() ? "" : sealed_columns(order) + " || ") +
                   sealed_columns(part.columns) + " || E'\\n', ''" +
                   (order.empty() ? "" : " ORDER BY " + order) + ") INTO rows FROM public." +
                   std::string(part.table) + " WHERE " + std::string(part.key.front()) +
                   " = of_id;\n";
            if (number == 0) sql += "        IF rows IS NULL THEN RETURN ''; END IF;\n";
            sql += "        IF rows IS NOT NULL THEN parts := parts || '" + std::to_string(number) +
                   " ' || placode_guard.checksum(convert_to(rows, 'UTF8')) || E'\\n'; END IF;\n";
        }
        sql += "    END IF;\n";
    }
    return sql + "    RETURN parts;\nEND $$";
}

/// The rights that hashes and names of accounts need, after those of all tables were given.
std::string rights_statement() {
    return std::string(
               "DO $$ DECLARE shown TEXT; BEGIN\n"
               "    REVOKE INSERT ON public.accounts, public.persons, public.account_pins, "
               "public.audit, public.attempts FROM ") +
           kStationRole +
           ";\n"
           // Never its number, nor that it was simulated again, or read for it.
           "    SELECT string_agg(quote_ident(column_name), ', ') INTO shown FROM "
           "information_schema.columns WHERE table_schema = 'public' AND table_name = 'attempts' "
           "AND column_name NOT IN ('id', 'replayed_utc', 'generated_from', 'read_by');\n"
           "    EXECUTE 'GRANT INSERT (' || shown || ') ON public.attempts TO " +
           kStationRole +
           "';\n"
           "    REVOKE SELECT ON public.accounts, public.account_pins FROM " +
           kStationRole +
           ";\n"
           "    SELECT string_agg(quote_ident(column_name), ', ') INTO shown FROM "
           "information_schema.columns WHERE table_schema = 'public' AND table_name = 'accounts' "
           "AND column_name NOT IN (" +
           kHiddenColumns +
           ");\n"
           "    EXECUTE 'GRANT SELECT (' || shown || ') ON public.accounts TO " +
           kStationRole +
           "';\n"
           "    GRANT SELECT (account_id, failures) ON public.account_pins TO " +
           kStationRole +
           ";\n"
           "    IF EXISTS (SELECT FROM pg_roles WHERE rolname = '" +
           kServiceRole +
           "') THEN\n"
           "        GRANT INSERT ON public.accounts, public.persons, public.attempts TO " +
           kServiceRole + ";\n    END IF;\nEND $$";
}

/// Last, and in one go: until then nobody reaches the schema.
std::string opening_statement() {
    return std::string(
               "DO $$ DECLARE each REGPROCEDURE; BEGIN\n"
               "    REVOKE ALL ON ALL FUNCTIONS IN SCHEMA placode_guard FROM PUBLIC, ") +
           kStationRole +
           ";\n"
           "    FOR each IN SELECT p.oid FROM pg_proc p WHERE p.pronamespace = "
           "'placode_guard'::regnamespace AND p.proname IN (" +
           kCalled +
           ") LOOP\n"
           "        EXECUTE 'GRANT EXECUTE ON FUNCTION ' || each || ' TO " +
           kStationRole +
           "';\n"
           "    END LOOP;\n"
           "    GRANT USAGE ON SCHEMA placode_guard TO " +
           kStationRole + ";\nEND $$";
}

std::vector<std::string> unmarked_statements() {
    std::vector<std::string> sql;
    add_statements(sql, kGuardTables);
    sql.push_back(std::string("REVOKE ALL ON SCHEMA placode_guard FROM PUBLIC, ") + kStationRole);
    sql.push_back(std::string("REVOKE ALL ON ALL TABLES IN SCHEMA placode_guard FROM PUBLIC, ") +
                  kStationRole);
    for (const char* text :
         {kGuardChecksum, kGuardIdentity, kGuardChannel, kGuardSignIn, kGuardAccounts, kGuardScopes,
          kGuardAttempts, kGuardAnswers, kGuardExams, kGuardWords})
        add_statements(sql, text);
    sql.push_back(seal_statement());
    for (const TableRule& rule : kRules) sql.push_back(rule_statement(rule));
    sql.push_back(rights_statement());
    return sql;
}

/// Of all that is installed, with the rights to rows: a program whose rules are others is told so.
const std::string& version() {
    static const std::string checksum = [] {
        std::string all = opening_statement();
        for (const std::string& each : unmarked_statements()) all += each;
        for (const std::string& each : station_table_rights()) all += each;
        return checksum_hex(all);
    }();
    return checksum;
}

}  // namespace

bool server_seals(std::string_view kind) {
    return std::find(kSealedByServer.begin(), kSealedByServer.end(), kind) != kSealedByServer.end();
}

std::vector<std::string> station_guard_statements() {
    std::vector<std::string> sql = unmarked_statements();
    sql.push_back(
        "CREATE OR REPLACE FUNCTION placode_guard.version() RETURNS TEXT LANGUAGE sql IMMUTABLE "
        "SET search_path = pg_catalog, pg_temp AS $$ SELECT '" +
        version() + "'::TEXT $$");
    sql.push_back(opening_statement());
    return sql;
}

Said guard_refusal() {
    return Said::that(
        "you may not do this on the server; sign in again with an account that may; nothing was "
        "changed");
}

bool has_station_guard(Connection& connection) {
    {
        Statement there(connection,
                        "SELECT COUNT(*) FROM pg_proc p JOIN pg_namespace n ON n.oid = "
                        "p.pronamespace WHERE n.nspname = 'placode_guard' AND p.proname = "
                        "'version'");
        if (!there.run().next() || there.integer(0) == 0) return false;
    }
    {
        Statement may(connection,
                      "SELECT CASE WHEN has_schema_privilege('placode_guard', 'USAGE') THEN 1 "
                      "ELSE 0 END");
        if (!may.run().next() || may.integer(0) == 0) return false;
    }
    Statement query(connection, "SELECT placode_guard.version()");
    return query.run().next() && query.text(0) == version();
}

std::vector<std::string> station_guard_problems(Connection& connection) {
    std::vector<std::string> problems;
    const std::string way_out = "; their owner runs `placodectl station role --apply`";
    if (!has_station_guard(connection))
        problems.push_back(
            "guard: the server's own rules are missing or of another version of this program" +
            way_out);
    std::string tables;
    for (const TableRule& rule : kRules)
        tables += std::string(tables.empty() ? "'" : ", '") + rule.table + "'";
    int64_t there = 0, forced = 0, policies = 0;
    {
        Statement query(connection,
                        "SELECT COUNT(*), COUNT(*) FILTER (WHERE relrowsecurity AND "
                        "relforcerowsecurity) FROM pg_class WHERE relnamespace = "
                        "'public'::regnamespace AND relname IN (" +
                            tables + ")");
        if (query.run().next()) {
            there = query.integer(0);
            forced = query.integer(1);
        }
    }
    {
        Statement query(connection,
                        "SELECT COUNT(*) FROM pg_policies WHERE schemaname = 'public' AND "
                        "permissive = 'PERMISSIVE' AND policyname IN ('owner_all', "
                        "'station_reads', 'station_adds', 'station_changes', 'station_removes') "
                        "AND tablename IN (" +
                            tables + ")");
        if (query.run().next()) policies = query.integer(0);
    }
    int64_t all = 0;
    {
        Statement query(connection,
                        "SELECT COUNT(*) FROM pg_policies WHERE schemaname = 'public' AND "
                        "tablename IN (" +
                            tables + ")");
        if (query.run().next()) all = query.integer(0);
    }
    int64_t triggers = 0;
    {
        Statement query(connection,
                        "SELECT COUNT(*) FROM pg_trigger WHERE tgrelid = "
                        "'public.attempts'::regclass AND NOT tgisinternal AND tgenabled = 'O' AND "
                        "tgname IN ('watch_attempt', 'need_recording')");
        if (query.run().next()) triggers = query.integer(0);
    }
    if (triggers != kTriggersOfAttempts)
        problems.push_back("guard: triggers of attempts are missing or switched off" + way_out);
    if (forced != there || policies != there * kPoliciesOfATable || all != policies)
        problems.push_back("guard: policies of the tables are missing, added or switched off" +
                           way_out);
    return problems;
}

}  // namespace placode::db

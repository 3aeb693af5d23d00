// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/station_guard.h"

#include <array>

#include "db/packing.h"
#include "db/station_role.h"

namespace placode::db {
namespace {

// Sums of the bits of db/records.h, Role, as SQL.
constexpr const char* kAdministrator = "placode_guard.need(8)";
constexpr const char* kOwnOrAdministrator = "placode_guard.need(8, account_id)";
constexpr const char* kEducator = "placode_guard.need(2)";
constexpr const char* kOwnOrEducator = "placode_guard.need(2, account_id)";
constexpr const char* kTeachesOrAdministers = "placode_guard.need(10)";
constexpr const char* kCoordinator = "placode_guard.need(4)";
constexpr const char* kErases = "placode_guard.need(12)";  ///< A person, or a participant's data.
constexpr const char* kStaff = "placode_guard.need(14)";
constexpr const char* kAnybody = "true";

/// What has to hold, as SQL over the row, for a station that adds, changes or removes one. It never
/// widens the rights of db/station_role.cpp. The table is that of db/access.cpp, as far as roles
/// decide; which groups somebody teaches only the program asks.
struct TableRule {
    const char* table;
    const char* adds;
    const char* changes;
    const char* removes;
};

constexpr std::array kRules{
    TableRule{"accounts", kAdministrator, kAdministrator, kAdministrator},
    TableRule{"persons", kAdministrator, kAdministrator, kAdministrator},
    TableRule{"account_pins", kAdministrator, kAdministrator, kOwnOrAdministrator},
    TableRule{"invitations", kAdministrator, kAdministrator, kAdministrator},
    TableRule{"erasure_requests", kOwnOrAdministrator, kAdministrator, kAdministrator},
    TableRule{"training_groups", kTeachesOrAdministers, kAdministrator, kAdministrator},
    TableRule{"group_members", kTeachesOrAdministers, kAdministrator, kTeachesOrAdministers},
    TableRule{"course_assignments", kEducator, kEducator, kAdministrator},
    TableRule{"course_grants", kEducator, kAdministrator, kAdministrator},
    TableRule{"certificates", kOwnOrEducator, kAdministrator, kAdministrator},
    TableRule{"trusted_centres", kTeachesOrAdministers, kAdministrator, kAdministrator},
    TableRule{"centre_key", kTeachesOrAdministers, kTeachesOrAdministers, kAdministrator},
    TableRule{"norm_packs", kEducator, kEducator, kAdministrator},
    // What was performed is saved for its owner whoever has signed in meanwhile.
    TableRule{"attempts", kAnybody, kAnybody, kErases},
    TableRule{"attempt_metrics", kAnybody, kErases, kErases},
    TableRule{"attempt_reasons", kAnybody, kErases, kErases},
    TableRule{"attempt_events", kAnybody, kErases, kErases},
    TableRule{"attempt_scores", kAnybody, kErases, kErases},
    TableRule{"attempt_score_metrics", kAnybody, kErases, kErases},
    TableRule{"attempt_score_reasons", kAnybody, kErases, kErases},
    TableRule{"recordings", kAnybody, kErases, kErases},
    // Steps and answers of a session that was begun are kept as well.
    TableRule{"answers", kAnybody, kCoordinator, kCoordinator},
    TableRule{"answer_items", kAnybody, kCoordinator, kCoordinator},
    TableRule{"answer_changes", kAnybody, kCoordinator, kCoordinator},
    TableRule{"study_steps", kAnybody, kCoordinator, kCoordinator},
    TableRule{"participants", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"participant_states", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"participant_devices", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"withdrawals", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"consent_signatures", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"answer_corrections", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"second_entries", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"second_entry_items", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"superseded_steps", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"step_notes", kCoordinator, kCoordinator, kCoordinator},
    TableRule{"record_events", kCoordinator, kErases, kAdministrator},
    TableRule{"study_allocations", kStaff, kStaff, kAdministrator},
};
constexpr int kPoliciesOfATable = 5;

/// What stations call; all other functions only these call.
constexpr const char* kCalled =
    "'open_channel', 'salt_of', 'enter', 'resume', 'leave', 'pin_salt_of', 'enter_by_pin', "
    "'drop_worn_pin', 'add_account', 'accept_invitation', 'set_password', 'set_pin', "
    "'seal_of_account', 'seal_of_pin', 'me', 'need', 'version'";

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
    sql += "    CREATE POLICY station_reads" + on + " FOR SELECT" + to + " USING (true);\n";
    sql += "    CREATE POLICY station_adds" + on + " FOR INSERT" + to + " WITH CHECK (" +
           rule.adds + ");\n";
    sql += "    CREATE POLICY station_changes" + on + " FOR UPDATE" + to + " USING (" +
           rule.changes + ");\n";
    sql += "    CREATE POLICY station_removes" + on + " FOR DELETE" + to + " USING (" +
           rule.removes + ");\n";
    return sql + "    ALTER TABLE public." + rule.table +
           " ENABLE ROW LEVEL SECURITY, FORCE ROW LEVEL SECURITY;\nEND $$";
}

/// The rights that hashes and names of accounts need, after those of all tables were given.
std::string rights_statement() {
    return std::string(
               "DO $$ DECLARE shown TEXT; BEGIN\n"
               "    REVOKE INSERT ON public.accounts, public.persons, public.account_pins FROM ") +
           kStationRole +
           ";\n"
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
           "        GRANT INSERT ON public.accounts, public.persons TO " +
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
         {kGuardChecksum, kGuardIdentity, kGuardChannel, kGuardSignIn, kGuardAccounts})
        add_statements(sql, text);
    for (const TableRule& rule : kRules) sql.push_back(rule_statement(rule));
    sql.push_back(rights_statement());
    return sql;
}

/// Of all that is installed: a program whose rules are others is told so.
const std::string& version() {
    static const std::string checksum = [] {
        std::string all = opening_statement();
        for (const std::string& each : unmarked_statements()) all += each;
        return checksum_hex(all);
    }();
    return checksum;
}

}  // namespace

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
    if (forced != there || policies != there * kPoliciesOfATable || all != policies)
        problems.push_back("guard: policies of the tables are missing, added or switched off" +
                           way_out);
    return problems;
}

}  // namespace placode::db

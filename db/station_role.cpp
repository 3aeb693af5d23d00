// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/station_role.h"

#include <array>
#include <utility>

#include "db/station_guard.h"

namespace placode::db {
namespace {

struct TableRight {
    const char* table;
    const char* columns;  ///< That may be changed; "" = none.
    bool removes = false;
};

// Beside reading and adding rows. What stands here is what statements in db/*.cpp do; the tests of
// the store run with a station's log-in and find what is missing.
constexpr std::array kRights{
    TableRight{"accounts", "roles, active"},
    TableRight{"persons", "", true},
    TableRight{"sign_in_failures", "failures, last_ms", true},
    TableRight{"account_pins", "", true},
    TableRight{"invitations", "used_utc, note"},
    TableRight{"erasure_requests", "reason, done_utc"},
    TableRight{"group_members", "teaches", true},
    TableRight{"course_assignments", "ended_utc", true},
    TableRight{"course_grants", "", true},
    TableRight{"exam_begins", "", true},
    TableRight{"certificates", "", true},
    TableRight{"norm_packs", "in_use"},
    TableRight{"attempts",
               "replay, replayed_utc, void_reason, void_meaning, study, participant, read_by",
               true},
    TableRight{"attempt_metrics", "", true},
    TableRight{"attempt_reasons", "", true},
    TableRight{"attempt_events", "", true},
    TableRight{"attempt_scores", "", true},
    TableRight{"attempt_score_metrics", "", true},
    TableRight{"attempt_score_reasons", "", true},
    TableRight{"recordings", "", true},
    TableRight{"attempt_comments", "removed_utc"},
    TableRight{"answers", "", true},
    TableRight{"answer_items", "", true},
    TableRight{"answer_changes", "", true},
    TableRight{"answer_corrections", "", true},
    TableRight{"second_entries", "", true},
    TableRight{"second_entry_items", "", true},
    TableRight{"study_steps", "", true},
    TableRight{"superseded_steps", "", true},
    TableRight{"step_notes", "", true},
    TableRight{"participant_devices", "device, chosen_by, chosen_utc", true},
    TableRight{"consent_signatures", "path", true},
    TableRight{"record_events", "by_name, remark"},
    TableRight{"withdrawals", "mode, reason, withdrawn_by, withdrawn_utc"},
};

const std::string kRole = kStationRole;
constexpr const char* kOwns =
    "EXISTS (SELECT FROM pg_tables WHERE schemaname = 'public' AND pg_has_role(current_user, "
    "tableowner, 'MEMBER'))";

// What a station should not be able to do, as SQL, and how it is said.
constexpr const char* kIsService =
    "EXISTS (SELECT FROM pg_roles WHERE rolname = 'placode_service' AND NOT (SELECT rolsuper FROM "
    "pg_roles WHERE rolname = current_user) AND pg_has_role(current_user, oid, 'MEMBER'))";
constexpr std::array<std::pair<const char*, const char*>, 7> kBeyond{{
    {"(SELECT rolsuper FROM pg_roles WHERE rolname = current_user)",
     "is superuser of the server: it reads and changes everything"},
    {"(SELECT rolcreaterole FROM pg_roles WHERE rolname = current_user)",
     "may give itself the rights of other roles"},
    {kOwns,
     "owns tables, or may become their owner: it can change scores and switch the guards of the "
     "trail off"},
    // Columns that no station may change, of which one stands for all.
    {"has_column_privilege('attempts', 'points', 'UPDATE') OR has_table_privilege('audit', "
     "'UPDATE') OR has_table_privilege('audit', 'DELETE') OR has_column_privilege('audit', 'id', "
     "'INSERT') OR has_table_privilege('definitions', "
     "'UPDATE')",
     "may change scores, published texts or the trail"},
    {"has_schema_privilege('public', 'CREATE')", "may make tables and functions"},
    {kIsService,
     "is a service's: the server takes its word for whom it works, so it is not for people"},
    {"has_column_privilege('accounts', 'password_hash', 'SELECT')", "may read hashes of passwords"},
}};

std::vector<std::string> grants() {
    std::vector<std::string> sql{
        "DO $$ BEGIN EXECUTE format('REVOKE TEMPORARY ON DATABASE %I FROM PUBLIC', "
        "current_database()); END $$",
        "REVOKE CREATE ON SCHEMA public FROM PUBLIC",
        "GRANT USAGE ON SCHEMA public TO " + kRole,
        "REVOKE ALL ON ALL TABLES IN SCHEMA public FROM PUBLIC, " + kRole,
        "GRANT SELECT, INSERT ON ALL TABLES IN SCHEMA public TO " + kRole,
        "REVOKE INSERT ON schema_migrations FROM " + kRole,
        // Never its number: one before the first would begin the trail, one far on end it.
        "REVOKE INSERT ON audit FROM " + kRole,
        "GRANT INSERT (at_utc, actor, action, object, detail, chain, seals, station, signature) ON "
        "audit TO " +
            kRole,
    };
    for (std::string& each : station_table_rights()) sql.push_back(std::move(each));
    for (std::string& each : station_guard_statements()) sql.push_back(std::move(each));
    return sql;
}

}  // namespace

std::vector<std::string> station_table_rights() {
    std::vector<std::string> sql;
    for (const TableRight& right : kRights) {
        if (*right.columns != '\0')
            sql.push_back(std::string("GRANT UPDATE (") + right.columns + ") ON " + right.table +
                          " TO " + kRole);
        if (right.removes)
            sql.push_back(std::string("GRANT DELETE ON ") + right.table + " TO " + kRole);
    }
    return sql;
}

std::vector<std::string> station_role_statements() {
    std::vector<std::string> sql{
        "DO $$ BEGIN\n"
        "    IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = '" +
        kRole +
        "') THEN\n"
        "        CREATE ROLE " +
        kRole +
        " NOLOGIN;\n"
        "    END IF;\n"
        "    IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = '" +
        kServiceRole +
        "') AND (SELECT rolcreaterole OR rolsuper FROM pg_roles WHERE rolname = current_user) "
        "THEN\n"
        "        CREATE ROLE " +
        kServiceRole + " NOLOGIN IN ROLE " + kRole +
        ";\n"
        "    END IF;\n"
        "END $$"};
    for (std::string& each : grants()) sql.push_back(std::move(each));
    return sql;
}

bool owns_tables(Connection& connection) {
    Statement query(connection, std::string("SELECT CASE WHEN ") + kOwns + " THEN 1 ELSE 0 END");
    return query.run().next() && query.integer(0) != 0;
}

void give_station_role(Connection& connection) {
    if (connection.is_sqlite())
        connection.fail(StoreError::Kind::kRefused,
                        "a store that is a file has no log-ins; this is for a server");
    // For somebody else PostgreSQL would warn, and give nothing.
    if (!owns_tables(connection)) connection.fail(StoreError::Kind::kRefused, kOnlyTheOwner);
    for (const std::string& each : station_role_statements()) {
        try {
            UnitOfWork work(connection);
            connection.execute(each);
            work.commit();
        } catch (const StoreError& error) {
            throw StoreError(
                StoreError::Kind::kRefused,
                std::string(error.what()) +
                    "; if this log-in may not make roles, have the server's administrator run "
                    "CREATE ROLE " +
                    kRole + " NOLOGIN first");
        }
    }
}

bool has_station_role(Connection& connection) {
    if (connection.is_sqlite()) return false;
    Statement query(connection, "SELECT COUNT(*) FROM pg_roles WHERE rolname = ?");
    return query.run(kRole).next() && query.integer(0) > 0;
}

void renew_station_role(Connection& connection, bool changed) {
    if (!has_station_role(connection)) return;
    if (!changed && (!owns_tables(connection) || has_station_guard(connection))) return;
    UnitOfWork work(connection);
    for (const std::string& each : grants()) connection.execute(each);
    work.commit();
}

namespace {

std::vector<std::string> what_it_may_beyond(Connection& connection, bool service = false) {
    std::vector<std::string> problems;
    std::string columns;
    for (const auto& [condition, problem] : kBeyond)
        columns += (columns.empty() ? "CASE WHEN " : ", CASE WHEN ") + std::string(condition) +
                   " THEN 1 ELSE 0 END";
    Statement query(connection, "SELECT " + columns);
    if (!query.run().next()) return problems;
    const std::string user = connection.url().user;
    const std::string role = user.empty() ? "the role" : "the role \"" + user + "\"";
    for (size_t i = 0; i < kBeyond.size(); ++i)
        if (query.integer(static_cast<int>(i)) != 0 && !(service && kBeyond[i].first == kIsService))
            problems.push_back("role: " + role + " " + kBeyond[i].second);
    return problems;
}

}  // namespace

std::vector<std::string> station_role_problems(Connection& connection) {
    if (connection.is_sqlite()) return {};
    std::vector<std::string> problems = what_it_may_beyond(connection);
    if (has_station_role(connection))
        for (std::string& each : station_guard_problems(connection))
            problems.push_back(std::move(each));
    return problems;
}

void need_station_role(Connection& connection, bool service) {
    if (!has_station_role(connection)) return;
    if (service) {
        Statement query(connection,
                        std::string("SELECT CASE WHEN ") + kIsService + " THEN 1 ELSE 0 END");
        if (query.run().next() && query.integer(0) == 0)
            connection.fail(StoreError::Kind::kRefused,
                            Said::that("people come from a learning platform without signing in to "
                                       "the server; use a log-in that is member of "
                                       "placode_service, on a computer that no trainee uses"));
    }
    const auto problems = what_it_may_beyond(connection, service);
    if (!problems.empty())
        connection.fail(StoreError::Kind::kRefused,
                        Said::that("this log-in to the server can do more than a station should "
                                   "(%1); use one that is member of placode_station")
                            .with(problems.front()));
    if (!station_guard_problems(connection).empty())
        connection.fail(
            StoreError::Kind::kRefused,
            Said::that("the rules that the server keeps by itself are missing or of another "
                       "version; the owner of its tables runs `placodectl station role --apply`"));
}

}  // namespace placode::db

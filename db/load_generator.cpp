// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/load_generator.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "curriculum/utc_time.h"
#include "db/store.h"
#include "db/store_context.h"
#include "sim/core/random.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr int64_t kFirstDay = 1735689600;  // 2025-01-01
constexpr int kDays = 700;

std::vector<int64_t> ids_of(Connection& connection, const std::string& sql) {
    Statement query(connection, sql);
    query.run();
    std::vector<int64_t> ids;
    while (query.next()) ids.push_back(query.integer(0));
    return ids;
}

void need_place_for_copies(Connection& connection) {
    if (!ids_of(connection, "SELECT id FROM accounts WHERE demonstration = 0 LIMIT 1").empty())
        connection.fail(
            Kind::kRefused,
            "the store has people of its own; give an empty one, copies are not for it");
    if (!ids_of(connection, "SELECT id FROM attempts WHERE generated_from <> 0 LIMIT 1").empty())
        connection.fail(Kind::kRefused, "the store holds copies already; give an empty one");
}

void add_people(Connection& connection, const LoadOrder& order, LoadResult& result) {
    Statement account(connection,
                      "INSERT INTO accounts (password_hash, roles, active, demonstration, "
                      "created_utc) VALUES ('', 1, 1, 1, ?) RETURNING id");
    Statement person(connection,
                     "INSERT INTO persons (account_id, login, login_key, display_name) VALUES (?, "
                     "?, ?, ?)");
    Statement group(connection,
                    "INSERT INTO training_groups (name, name_key, created_utc) VALUES (?, ?, ?) "
                    "RETURNING id");
    Statement member(connection,
                     "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, 0)");
    int64_t group_id = 0;
    for (int i = 0; i < order.users; ++i) {
        if (i % order.group_size == 0) {
            const std::string name = "generated cohort " + std::to_string(++result.groups);
            group_id = group.run(name, name, utc_now()).returned_id();
            if (result.first_group == 0) result.first_group = group_id;
        }
        const std::string login = "generated-" + std::to_string(i + 1);
        const int64_t id = account.run(utc_now()).returned_id();
        if (result.first_user == 0) result.first_user = id;
        person.run(id, login, login, "Generated " + std::to_string(i + 1));
        member.run(group_id, id);
    }
    result.users = order.users;
}

/// Rows of the table attempts. Returns false when it was stopped.
bool add_attempts(Connection& connection, const LoadOrder& order,
                  const std::vector<int64_t>& sources, LoadResult& result) {
    Statement insert(
        connection,
        "INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "
        "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, points, "
        "verdict, rubric_id, rubric_version, metric_set_version, preprocessing_version, "
        "generated_from) SELECT CAST(? AS BIGINT), task_id, task_version, CAST(? AS TEXT), CAST(? "
        "AS "
        "TEXT), duration_s, device, seed, build, 1, final_hash, dropped, " +
            std::string(order.sealed ? "0" : "1") +
            ", CAST(? AS DOUBLE PRECISION), CAST(? AS BIGINT), rubric_id, rubric_version, "
            "metric_set_version, preprocessing_version, id FROM attempts WHERE id = ?");
    sim::SplitMix64 random(order.seed);
    for (int64_t i = 0; i < order.attempts; ++i) {
        const int64_t user = i % order.users, trial = i / order.users + 1;
        // A person's attempts lie in order of time; who begins when differs.
        const int64_t day =
            (user * 7 + trial * kDays * order.users / (order.attempts + order.users)) % kDays;
        const std::string at = curriculum::utc_text(kFirstDay + day * 86400 +
                                                    static_cast<int64_t>(random.uniform() * 36000));
        const double learnt = 85 - 60 * std::exp(-static_cast<double>(trial) / 15);
        const double points = std::clamp(learnt + 30 * (random.uniform() - 0.5), 0.0, 100.0);
        const int verdict = random.uniform() < 0.05 ? 2 : points >= 70 ? 0 : 1;
        insert.run(result.first_user + user, at, at, points, verdict,
                   sources[static_cast<size_t>(i) % sources.size()]);
        if (i % 1000 == 0 && order.progress && !order.progress(i, order.attempts)) return false;
    }
    result.attempts = order.attempts;
    return true;
}

/// What hangs on the attempts is copied inside the engine.
void add_lists(Connection& connection, LoadResult& result) {
    const auto copy = [&](const std::string& sql) {
        Statement statement(connection, sql);
        result.rows += statement.run().affected();
    };
    copy(
        "INSERT INTO attempt_metrics (attempt_id, position, metric_id, value) SELECT t.id, "
        "m.position, m.metric_id, m.value * (0.9 + 0.0002 * ((t.id * 7919 + m.position * 104729) % "
        "1000)) FROM attempts t JOIN attempt_metrics m ON m.attempt_id = t.generated_from WHERE "
        "t.generated_from <> 0");
    copy(
        "INSERT INTO attempt_reasons (attempt_id, position, item, reason, points, time_s, "
        "critical, meaning) "
        "SELECT t.id, r.position, r.item, r.reason, r.points, r.time_s, r.critical, r.meaning FROM "
        "attempts t JOIN attempt_reasons r ON r.attempt_id = t.generated_from WHERE "
        "t.generated_from <> 0");
    copy(
        "INSERT INTO attempt_events (attempt_id, position, time_s, kind, tool, tissue, value, "
        "value2, rest_x_m, rest_y_m, rest_z_m, element) SELECT t.id, e.position, e.time_s, e.kind, "
        "e.tool, e.tissue, e.value, e.value2, e.rest_x_m, e.rest_y_m, e.rest_z_m, e.element FROM "
        "attempts t JOIN attempt_events e ON e.attempt_id = t.generated_from WHERE "
        "t.generated_from <> 0");
}

}  // namespace

LoadResult generate_load(const std::string& store_url, const LoadOrder& order) {
    (void)open_store(store_url);  // Creates and migrates.
    StoreContext context(parse_store_url(store_url), {});
    context.actor.name = "placodectl bench store";
    Connection& connection = context.connection;
    connection.begin_operation("multiply attempts in");
    LoadResult result;
    UnitOfWork work(connection);
    need_place_for_copies(connection);
    const auto sources =
        ids_of(connection, "SELECT id FROM attempts WHERE generated_from = 0 ORDER BY id");
    if (sources.empty())
        connection.fail(Kind::kRefused, "there is no attempt to multiply; simulate one first");
    result.sources = static_cast<int64_t>(sources.size());
    add_people(connection, order, result);
    if (!add_attempts(connection, order, sources, result)) {
        result.cancelled = true;
        return result;
    }
    add_lists(connection, result);
    result.rows += result.attempts;
    context.seal_the_unsealed();  // people and groups, and copies where that was ordered
    work.commit();
    // A server does this by itself after a while; the measurement must not wait for it.
    connection.execute(connection.is_sqlite() ? "ANALYZE" : "VACUUM ANALYZE");
    return result;
}

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that stay quick with a hundred thousand attempts: pages, and sums made by the engine.

#include "db/sql_store.h"

namespace placode::db {

AttemptConditions conditions_of(int64_t user_id, int64_t group_id, const std::string& task_id) {
    AttemptConditions made;
    if (user_id != 0) made.add("t.account_id = ?", QVariant(qlonglong(user_id)));
    if (group_id != 0)
        made.add(
            "t.account_id IN (SELECT account_id FROM group_members WHERE teaches = 0 AND "
            "group_id = ?)",
            QVariant(qlonglong(group_id)));
    if (!task_id.empty()) made.add("t.task_id = ?", QVariant(QString::fromStdString(task_id)));
    return made;
}

namespace {

/// Interrupted attempts count nowhere, nor do exams that are void for cause.
const std::string kFinished = "t.void_reason = '' AND t.end_reason <> " +
                              std::to_string(static_cast<int>(sim::EndReason::kInterrupted));

std::string finished(const AttemptConditions& conditions) {
    return conditions.sql + (conditions.sql.empty() ? " WHERE " : " AND ") + kFinished;
}

}  // namespace

AttemptPage SqlStore::attempt_page(const AttemptFilter& filter) {
    connection_.begin_operation("list attempts of");
    const AttemptConditions where = conditions_of(filter.user_id, filter.group_id, filter.task_id);
    AttemptPage page;
    Statement count(connection_, "SELECT COUNT(*) FROM attempts t" + where.sql);
    count.run_list(where.values);
    if (count.next()) page.total = count.integer(0);
    const std::string direction = filter.newest_first ? " DESC" : "";
    std::vector<QVariant> values = where.values;
    values.emplace_back(filter.limit);
    values.emplace_back(qlonglong(filter.offset));
    // The page's ids first, from an index alone; then the rows of one page.
    Statement query(connection_, attempt_columns() +
                                     "WHERE t.id IN (SELECT id FROM (SELECT t.id "
                                     "AS id FROM attempts t" +
                                     where.sql + " ORDER BY t.started_utc" + direction + ", t.id" +
                                     direction + " LIMIT ? OFFSET ?) AS chosen) ORDER BY " +
                                     "t.started_utc" + direction + ", t.id" + direction);
    query.run_list(values);
    while (query.next()) page.rows.push_back(read_attempt(query));
    return page;
}

std::vector<TaskStanding> SqlStore::task_standings(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("sum up attempts of");
    const AttemptConditions where = conditions_of(0, group_id, task_id);
    // Sums first, over an index that holds all they need; then the row of the last attempt.
    Statement query(
        connection_,
        "SELECT s.account_id, COALESCE(p.display_name, ''), s.task_id, s.n, s.failed, s.best, "
        "s.mean, t.points, t.started_utc FROM (SELECT t.account_id, t.task_id, COUNT(*) AS n, "
        "SUM(CASE WHEN t.verdict = 2 THEN 1 ELSE 0 END) AS failed, MAX(t.points) AS best, "
        "AVG(t.points) AS mean, MAX(t.started_utc) AS last FROM attempts t" +
            finished(where) +
            " GROUP BY t.account_id, t.task_id) s JOIN attempts t ON t.account_id = s.account_id "
            "AND t.task_id = s.task_id AND t.started_utc = s.last LEFT JOIN persons p ON "
            "p.account_id = s.account_id ORDER BY p.login_key, s.account_id, s.task_id, t.id");
    query.run_list(where.values);
    std::vector<TaskStanding> found;
    while (query.next()) {
        TaskStanding one;
        one.user_id = query.integer(0);
        one.user_name = query.text(1);
        one.task_id = query.text(2);
        one.attempts = static_cast<int>(query.integer(3));
        one.failed = static_cast<int>(query.integer(4));
        one.best_points = query.real(5);
        one.mean_points = query.real(6);
        one.last_points = query.real(7);
        one.last_utc = query.text(8);
        // Two attempts of the same second: the later number is the last.
        if (!found.empty() && found.back().user_id == one.user_id &&
            found.back().task_id == one.task_id)
            found.back() = std::move(one);
        else
            found.push_back(std::move(one));
    }
    return found;
}

std::vector<AttemptPoint> SqlStore::attempt_points(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("read scores from");
    const AttemptConditions where = conditions_of(0, group_id, task_id);
    Statement query(connection_,
                    "SELECT t.account_id, t.id, t.task_id, t.started_utc, t.points, t.verdict FROM "
                    "attempts t" +
                        finished(where) + " ORDER BY t.account_id, t.task_id, t.started_utc, t.id");
    query.run_list(where.values);
    std::vector<AttemptPoint> found;
    while (query.next())
        found.push_back({query.integer(0), query.integer(1), query.text(2), query.text(3),
                         query.real(4), static_cast<assessment::Verdict>(query.integer(5))});
    return found;
}

}  // namespace placode::db

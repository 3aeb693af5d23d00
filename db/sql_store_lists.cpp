// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that stay quick with a hundred thousand attempts: pages, and sums made by the engine.

#include "db/sql_store.h"

namespace placode::db {

AttemptConditions conditions_of(int64_t user_id, int64_t group_id, const std::string& task_id,
                                Studies studies) {
    AttemptConditions made;
    if (studies == Studies::kLeftOut) made.add("t.study = ''");
    if (user_id != 0) made.add("t.account_id = ?", QVariant(qlonglong(user_id)));
    if (group_id != 0)
        made.add(
            "t.account_id IN (SELECT account_id FROM group_members WHERE teaches = 0 AND "
            "group_id = ?)",
            QVariant(qlonglong(group_id)));
    if (!task_id.empty()) made.add("t.task_id = ?", QVariant(QString::fromStdString(task_id)));
    return made;
}

std::string is_finished(const std::string& table) {
    return table + ".void_reason = '' AND " + table + ".study = '' AND " + table +
           ".end_reason <> " + std::to_string(static_cast<int>(sim::EndReason::kInterrupted)) +
           " AND " + table + ".verdict <> " +
           std::to_string(static_cast<int>(assessment::Verdict::kNotAttempted));
}

AttemptPage SqlStore::attempt_page(const AttemptFilter& filter) {
    connection_.begin_operation("list attempts of");
    const bool everybody = filter.user_id == 0 && filter.group_id == 0;
    const AttemptConditions where =
        conditions_of(filter.user_id, filter.group_id, filter.task_id,
                      filter.studies && everybody ? Studies::kTakenIn : Studies::kLeftOut);
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

std::vector<AttemptPoint> SqlStore::attempt_points(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("read scores from");
    const AttemptConditions where = conditions_of(0, group_id, task_id);
    Statement query(connection_,
                    "SELECT t.account_id, t.id, t.task_id, t.started_utc, t.points, t.verdict FROM "
                    "attempts t" +
                        where.sql + (where.sql.empty() ? " WHERE " : " AND ") + is_finished("t") +
                        " ORDER BY t.account_id, t.task_id, t.started_utc, t.id");
    query.run_list(where.values);
    std::vector<AttemptPoint> found;
    while (query.next())
        found.push_back({query.integer("account_id"), query.integer("id"), query.text("task_id"),
                         query.text("started_utc"), query.real("points"),
                         static_cast<assessment::Verdict>(query.integer("verdict"))});
    return found;
}

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lists that stay quick with a hundred thousand attempts: pages, and one thing of each attempt.

#include "db/attempt_rows.h"
#include "db/attempts.h"
#include "db/store_context.h"

namespace placode::db {

AttemptPage Attempts::page(const AttemptFilter& filter) {
    connection_.begin_operation("list attempts of");
    filter.user_id == 0 ? context_.need(Action::kViewAttempts)
                        : context_.need_for(Action::kViewAttempts, filter.user_id);
    const bool everybody = filter.user_id == 0 && filter.group_id == 0;
    const AttemptConditions where =
        conditions_of(filter.user_id, filter.group_id, filter.task_id,
                      filter.studies && everybody ? OfStudies::kTakenIn : OfStudies::kLeftOut);
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
    show_proctors(context_, page.rows);
    return page;
}

std::vector<AttemptPoint> Attempts::points(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("read scores from");
    context_.need(Action::kViewAttempts);
    const AttemptConditions where = conditions_of(0, group_id, task_id);
    Statement query(connection_,
                    "SELECT t.account_id, t.id, t.task_id, t.started_utc, t.points, t.verdict, "
                    "t.task_version FROM attempts t" +
                        where.sql + (where.sql.empty() ? " WHERE " : " AND ") + is_finished("t") +
                        " ORDER BY t.account_id, t.task_id, t.started_utc, t.id");
    query.run_list(where.values);
    std::vector<AttemptPoint> found;
    while (query.next())
        found.push_back({query.integer("account_id"), query.integer("id"), query.text("task_id"),
                         query.text("started_utc"), query.real("points"),
                         static_cast<assessment::Verdict>(query.integer("verdict")),
                         static_cast<int>(query.integer("task_version"))});
    return found;
}

std::vector<std::string> Attempts::tasks() {
    connection_.begin_operation("list tasks of");
    context_.need(Action::kViewAttempts);
    // From one name to the next over the index: SELECT DISTINCT reads every attempt.
    Statement next(connection_,
                   "SELECT MIN(task_id) FROM attempts WHERE task_id > ? AND study = ''");
    std::vector<std::string> found;
    for (std::string last;;) {
        next.run(last);
        if (!next.next()) break;
        last = next.text(0);
        if (last.empty()) break;
        found.push_back(last);
    }
    return found;
}

}  // namespace placode::db

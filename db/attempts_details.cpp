// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts by their ids. A round trip to a server takes longer than a hundred rows: as many
// questions for many attempts as for one.

#include "db/attempt_rows.h"
#include "db/attempts.h"
#include "db/id_parts.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Details = std::map<int64_t, AttemptDetail>;

std::map<int64_t, AttemptRecord> read_records(StoreContext& context,
                                              const std::vector<int64_t>& ids) {
    std::vector<AttemptRecord> rows;
    for (const IdPart& part : in_parts(ids)) {
        Statement query(context.connection, attempt_columns() + "WHERE t.id IN " + part.list);
        query.run_list(part.values);
        while (query.next()) rows.push_back(read_attempt(query));
    }
    show_proctors(context, rows);
    std::map<int64_t, AttemptRecord> found;
    for (AttemptRecord& each : rows) found.emplace(each.id, std::move(each));
    return found;
}

/// Asks for rows of these attempts and gives each to its attempt, in the order of the question.
template <class Take>
void take_rows(Connection& connection, const IdPart& part, const std::string& before_list,
               const std::string& order, Details& found, Take take) {
    Statement query(connection, before_list + " IN " + part.list + order);
    query.run_list(part.values);
    while (query.next()) {
        const auto at = found.find(query.integer("attempt_id"));
        if (at != found.end()) take(at->second, query);
    }
}

void take_lists(Connection& connection, const IdPart& part, Details& found) {
    const std::string order = " ORDER BY attempt_id, position";
    take_rows(connection, part,
              "SELECT attempt_id, metric_id, value FROM attempt_metrics WHERE attempt_id", order,
              found, [](AttemptDetail& detail, const Statement& row) {
                  detail.metrics.values.push_back({row.text("metric_id"), row.real("value")});
              });
    take_rows(connection, part,
              "SELECT attempt_id, item, reason, points, time_s, critical, meaning FROM "
              "attempt_reasons WHERE attempt_id",
              order, found, [](AttemptDetail& detail, const Statement& row) {
                  detail.score.reasons.push_back(read_reason(row));
              });
    take_rows(connection, part,
              "SELECT id AS attempt_id, haptic_certificate FROM attempts WHERE id", "", found,
              [](AttemptDetail& detail, const Statement& row) {
                  detail.haptic_certificate = row.text("haptic_certificate");
              });
    take_rows(connection, part,
              "SELECT attempt_id, time_s, kind, tool, tissue, value, value2, rest_x_m, rest_y_m, "
              "rest_z_m, element FROM attempt_events WHERE attempt_id",
              order, found, [](AttemptDetail& detail, const Statement& row) {
                  detail.events.push_back(read_event(row));
              });
}

Details read_details(StoreContext& context, const std::vector<int64_t>& ids) {
    Details found;
    for (auto& [id, record] : read_records(context, ids)) {
        AttemptDetail& detail = found[id];
        detail.metrics.version = record.metric_set_version;
        detail.score.points = record.points;
        detail.score.verdict = record.verdict;
        detail.score.rubric_id = record.rubric_id;
        detail.score.rubric_version = record.rubric_version;
        detail.score.metric_set_version = record.metric_set_version;
        detail.record = std::move(record);
    }
    for (const IdPart& part : in_parts(ids)) take_lists(context.connection, part, found);
    return found;
}

}  // namespace

std::map<int64_t, AttemptRecord> Attempts::records(const std::vector<int64_t>& ids) {
    connection_.begin_operation("read attempts from");
    context_.need_sight_of_attempts(ids);
    return read_records(context_, ids);
}

std::map<int64_t, AttemptDetail> Attempts::details(const std::vector<int64_t>& ids) {
    connection_.begin_operation("read attempts from");
    context_.need_sight_of_attempts(ids);
    return read_details(context_, ids);
}

AttemptDetail Attempts::detail(int64_t id) {
    connection_.begin_operation("read an attempt from");
    context_.need_sight_of_attempt(id);
    Details found = read_details(context_, {id});
    if (found.empty())
        connection_.fail(StoreError::Kind::kNotFound, "there is no attempt " + std::to_string(id));
    return std::move(found.begin()->second);
}

}  // namespace placode::db

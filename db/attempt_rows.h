// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Questions about the table attempts and how their rows are read. Only attempts*.cpp,
// attempt_doubts.cpp, course_rows.cpp and norms.cpp include this.

#include <QVariant>
#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"
#include "db/sql_connection.h"

namespace placode::db {

/// SELECT ... FROM attempts t ..., for read_attempt().
[[nodiscard]] const std::string& attempt_columns();
/// What only_shows() finds is void in it, whatever the row says of that.
[[nodiscard]] AttemptRecord read_attempt(const Statement& row);
/// From a question for item, reason, points, time_s, critical, meaning.
[[nodiscard]] assessment::Reason read_reason(const Statement& row);
/// From a question for all columns of attempt_events but the attempt's.
[[nodiscard]] sim::Event read_event(const Statement& row);

/// Metrics and reasons of an attempt or of a further score.
/// @param table "attempt" or "attempt_score", before "_metrics" and "_reasons".
/// @param owner column that refers to what `id` is.
void insert_score(Connection& connection, const std::string& table, const std::string& owner,
                  int64_t id, const assessment::MetricSet& metrics, const assessment::Score& score);

/// WHERE over `attempts t`. Conditions are written only where they are asked for: "(? = 0 OR ...)"
/// would keep the engine from using an index.
struct AttemptConditions {
    std::string sql;  ///< " WHERE ...", or empty.
    std::vector<QVariant> values;

    void add(const std::string& condition) {
        sql += (sql.empty() ? " WHERE " : " AND ") + condition;
    }
    void add(const std::string& condition, const QVariant& value) {
        add(condition);
        values.push_back(value);
    }
};
/// What participants did in studies is nobody's training.
enum class OfStudies : uint8_t { kLeftOut, kTakenIn };
/// 0 and empty = no condition.
[[nodiscard]] AttemptConditions conditions_of(int64_t user_id, int64_t group_id,
                                              const std::string& task_id,
                                              OfStudies studies = OfStudies::kLeftOut);
/// Why what a script did, or a recording that says it is a demonstration, is void.
[[nodiscard]] VoidReason shown_by(const std::string& device);
/// SQL over a row of attempts that is of no study: a demonstration, and not of an account that is
/// there to demonstrate. (In a study those of demonstration participants count, too.)
[[nodiscard]] std::string only_shows(const std::string& table);
/// Interrupted attempts count nowhere, nor do those that are void for cause, that only_shows()
/// finds, of a study, or exams that were not simulated again yet.
[[nodiscard]] std::string is_finished(const std::string& table);

}  // namespace placode::db

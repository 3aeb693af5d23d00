// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where people stand, from sums and the last few attempts of each: answered from an index alone,
// however many attempts there are.

#include <algorithm>
#include <map>
#include <tuple>

#include "db/accounts.h"
#include "db/attempt_rows.h"
#include "db/attempts.h"
#include "db/demonstration.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

std::string finished(const AttemptConditions& conditions) {
    return conditions.sql + (conditions.sql.empty() ? " WHERE " : " AND ") + is_finished("t");
}

std::string sums_sql(const AttemptConditions& where) {
    return "SELECT t.account_id, t.task_id, COUNT(*) AS n, SUM(CASE WHEN t.verdict = 2 THEN 1 ELSE "
           "0 END) AS failed, SUM(CASE WHEN t.verdict = 0 THEN 1 ELSE 0 END) AS passed, "
           "MAX(t.points) AS best, AVG(t.points) AS mean, MAX(t.started_utc) AS last, "
           "MAX(CASE WHEN t.verdict <> 0 THEN t.started_utc END) AS missed FROM attempts t" +
           finished(where) + " GROUP BY t.account_id, t.task_id";
}

/// " FROM attempts x WHERE" it is one of g's person and task.
std::string from_own(const std::string& x) {
    return " FROM attempts " + x + " WHERE " + x + ".account_id = g.account_id AND " + x +
           ".task_id = g.task_id AND " + is_finished(x);
}

/// A column of the first attempt of g's person and task in that order, after `offset` others;
/// `none` where there are fewer.
std::string of_attempt(const std::string& column, const std::string& order, int offset,
                       const std::string& none) {
    return "COALESCE((SELECT x." + column + from_own("x") + " ORDER BY " + order +
           " LIMIT 1 OFFSET " + std::to_string(offset) + "), " + none + ")";
}

/// How many attempts follow the last one that was not passed (of two in a second, the later one).
std::string streak_sql() {
    return "CASE WHEN g.missed IS NULL THEN g.n ELSE (SELECT COUNT(*)" + from_own("x") +
           " AND (x.started_utc, x.id) > (g.missed, (SELECT MAX(y.id)" + from_own("y") +
           " AND y.started_utc = g.missed AND y.verdict <> 0))) END";
}

/// A row for each of the last attempts of everybody in every task, oldest first; sums and the first
/// attempt's points stand in each. One question, because grouping reads every attempt.
std::string standings_sql(const AttemptConditions& where) {
    const std::string forward = "x.started_utc, x.id", back = "x.started_utc DESC, x.id DESC";
    const int before = assessment::kStuckTrials - 1;
    // Materialized: PostgreSQL would look for the beginning again for every attempt.
    return "WITH f AS MATERIALIZED (SELECT g.account_id, g.task_id, g.n, g.failed, g.passed, "
           "g.best, g.mean, g.last, " +
           of_attempt("points", forward, 0, "0") + " AS first_points, " +
           of_attempt("started_utc", back, before, "''") + " AS from_utc, " +
           of_attempt("id", back, before, "0") + " AS from_id, " + streak_sql() +
           " AS streak FROM (" + sums_sql(where) +
           ") g) SELECT f.account_id AS user_id, f.task_id AS task, x.points AS points, "
           "x.verdict AS verdict, COALESCE(p.display_name, '') AS user_name, COALESCE(a.active, 1) "
           "AS active, f.n AS attempts, "
           "f.failed AS failed, f.passed AS passed, f.best AS best, f.mean AS mean, f.last AS "
           "last_utc, f.first_points AS first_points, f.streak AS streak FROM f JOIN attempts x ON "
           "x.account_id = f.account_id AND x.task_id = f.task_id AND " +
           is_finished("x") +
           " AND (x.started_utc, x.id) >= (f.from_utc, f.from_id) LEFT JOIN persons p ON "
           "p.account_id = f.account_id LEFT JOIN accounts a ON a.id = f.account_id ORDER BY "
           "p.login_key, f.account_id, f.task_id, " +
           forward;
}

assessment::TrialOutcome read_outcome(const Statement& row) {
    return {row.real("points"), static_cast<assessment::Verdict>(row.integer("verdict")) ==
                                    assessment::Verdict::kPassed};
}

TaskStanding read_standing(const Statement& row) {
    TaskStanding one;
    one.user_id = row.integer("user_id");
    one.task_id = row.text("task");
    one.user_name = row.text("user_name");
    one.active = row.integer("active") != 0;
    one.attempts = one.trials.attempts = static_cast<int>(row.integer("attempts"));
    one.failed = static_cast<int>(row.integer("failed"));
    one.trials.passed = static_cast<int>(row.integer("passed"));
    one.best_points = one.trials.best = row.real("best");
    one.mean_points = row.real("mean");
    one.last_utc = row.text("last_utc");
    one.first_points = row.real("first_points");
    one.trials.streak = static_cast<int>(row.integer("streak"));
    return one;
}

/// Sums of everybody in every task, with the last outcomes of each.
std::vector<TaskStanding> read_standings(Connection& connection, const AttemptConditions& where) {
    Statement query(connection, standings_sql(where));
    query.run_list(where.values);
    std::vector<TaskStanding> found;
    while (query.next()) {
        if (found.empty() || found.back().user_id != query.integer("user_id") ||
            found.back().task_id != query.text("task"))
            found.push_back(read_standing(query));
        const assessment::TrialOutcome outcome = read_outcome(query);
        found.back().last_points = outcome.points;
        found.back().trials.last.push_back(outcome);
    }
    return found;
}

/// What sums do not tell, asked for the few of whom it matters: whether the best attempt lies
/// before the last ones of somebody who passed none of those.
class Closer {
 public:
    explicit Closer(Connection& connection)
        : outcomes_(connection,
                    "SELECT t.points, t.verdict FROM attempts t WHERE t.account_id = ? AND "
                    "t.task_id = ? AND " +
                        is_finished("t") + " ORDER BY t.started_utc, t.id") {}

    void complete(TaskStanding& one) {
        assessment::TrialSummary& trials = one.trials;
        const auto& last = trials.last;
        if (trials.attempts <= static_cast<int>(last.size())) return;
        double best = 0;
        bool passed = false;
        for (const assessment::TrialOutcome& each : last) {
            best = std::max(best, each.points);
            passed = passed || each.passed;
        }
        trials.best_before = trials.best;
        if (passed || best < trials.best) return;
        outcomes_.run(one.user_id, one.task_id);
        std::vector<assessment::TrialOutcome> every;
        while (outcomes_.next()) every.push_back(read_outcome(outcomes_));
        trials = assessment::summarise_trials(every);
    }

 private:
    Statement outcomes_;
};

}  // namespace

std::vector<TaskStanding> Attempts::standings(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("sum up attempts of");
    context_.need(Action::kViewAttempts);
    std::vector<TaskStanding> found =
        read_standings(connection_, conditions_of(0, group_id, task_id));
    Closer closer(connection_);
    for (TaskStanding& one : found) closer.complete(one);
    return found;
}

std::vector<RecentMean> Attempts::recent_means(const std::string& task_id, int last) {
    connection_.begin_operation("read scores from");
    context_.need(Action::kViewAttempts);
    // Before the question: PostgreSQL answers one at a time.
    std::map<int64_t, std::string> names;
    const std::vector<UserRecord> users = Accounts(context_).list();
    for (const UserRecord& user : users) names[user.id] = user.display_name;
    connection_.begin_operation("read scores from");
    // Marks are made of these means: what demonstrates sets none for real people.
    const std::string real = is_demonstration_store(users) ? "" : ".demonstration = 0 AND ";
    const auto taken = [&real](const std::string& table) {
        return (real.empty() ? "" : table + real) + is_finished(table);
    };
    const auto script = [](const std::string& table) {
        return "CASE WHEN " + table + ".device LIKE 'script:%' THEN " + table +
               ".device ELSE '' END";
    };
    Statement query(
        connection_,
        "SELECT g.account_id AS user_id, g.script AS script, g.n AS attempts, "
        "g.demonstration AS demonstration, (SELECT AVG(few.points) "
        "FROM (SELECT x.points FROM attempts x WHERE x.account_id = g.account_id AND "
        "x.task_id = ? AND " +
            taken("x") + " AND " + script("x") +
            " = g.script ORDER BY x.started_utc DESC, x.id DESC LIMIT ?) AS few) AS mean FROM "
            "(SELECT t.account_id, " +
            script("t") +
            " AS script, COUNT(*) AS n, MAX(t.demonstration) AS demonstration FROM "
            "attempts t WHERE t.task_id = ? AND " +
            taken("t") + " GROUP BY t.account_id, " + script("t") + ") g");
    query.run(task_id, int64_t{last}, task_id);
    std::vector<RecentMean> found;
    while (query.next()) {
        RecentMean one;
        one.user_id = query.integer("user_id");
        one.user_name = names[one.user_id];
        one.script = query.text("script");
        one.attempts = static_cast<int>(query.integer("attempts"));
        one.demonstration = query.integer("demonstration") != 0;
        one.mean_points = query.real("mean");
        found.push_back(std::move(one));
    }
    std::stable_sort(found.begin(), found.end(), [](const RecentMean& a, const RecentMean& b) {
        return std::tie(a.user_name, a.user_id, a.script) <
               std::tie(b.user_name, b.user_id, b.script);
    });
    return found;
}

}  // namespace placode::db

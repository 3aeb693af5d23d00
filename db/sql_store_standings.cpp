// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where people stand, from sums and the last few attempts of each: answered from an index alone,
// however many attempts there are.

#include <algorithm>
#include <map>
#include <tuple>

#include "db/sql_store.h"

namespace placode::db {
namespace {

using Key = std::pair<int64_t, std::string>;  // Person and task.

std::string finished(const AttemptConditions& conditions) {
    return conditions.sql + (conditions.sql.empty() ? " WHERE " : " AND ") + is_finished("t");
}

std::string sums_sql(const AttemptConditions& where) {
    return "SELECT t.account_id, t.task_id, COUNT(*) AS n, SUM(CASE WHEN t.verdict = 2 THEN 1 ELSE "
           "0 END) AS failed, SUM(CASE WHEN t.verdict = 0 THEN 1 ELSE 0 END) AS passed, "
           "MAX(t.points) AS best, AVG(t.points) AS mean, MIN(t.started_utc) AS begun, "
           "MAX(t.started_utc) AS last FROM attempts t" +
           finished(where) + " GROUP BY t.account_id, t.task_id";
}

/// Sums of every person in every task, with the first and the last attempt's points.
std::vector<TaskStanding> read_sums(Connection& connection, const AttemptConditions& where) {
    const auto of_the_same = [](const std::string& table, const std::string& at) {
        return " JOIN attempts " + table + " ON " + table + ".account_id = s.account_id AND " +
               table + ".task_id = s.task_id AND " + table + ".started_utc = s." + at + " AND " +
               is_finished(table);
    };
    Statement query(connection,
                    "SELECT s.account_id, COALESCE(p.display_name, ''), s.task_id, s.n, s.failed, "
                    "s.best, s.mean, t.points, s.last, s.passed, b.points FROM (" +
                        sums_sql(where) + ") s" + of_the_same("t", "last") +
                        of_the_same("b", "begun") +
                        " LEFT JOIN persons p ON p.account_id = s.account_id ORDER BY p.login_key, "
                        "s.account_id, s.task_id, t.id, b.id DESC");
    query.run_list(where.values);
    std::vector<TaskStanding> found;
    while (query.next()) {
        TaskStanding one;
        one.user_id = query.integer(0);
        one.user_name = query.text(1);
        one.task_id = query.text(2);
        one.attempts = one.trials.attempts = static_cast<int>(query.integer(3));
        one.failed = static_cast<int>(query.integer(4));
        one.best_points = one.trials.best = query.real(5);
        one.mean_points = query.real(6);
        one.last_points = query.real(7);
        one.last_utc = query.text(8);
        one.trials.passed = static_cast<int>(query.integer(9));
        one.first_points = query.real(10);
        // Two attempts of the same second: the later number is the last, the earlier the first.
        if (!found.empty() && found.back().user_id == one.user_id &&
            found.back().task_id == one.task_id)
            found.back() = std::move(one);
        else
            found.push_back(std::move(one));
    }
    return found;
}

/// Start and number of the `number`th attempt from the end; "" and 0 where there are fewer.
std::string from_the_end(const char* column, int number, const char* none) {
    return std::string("COALESCE((SELECT x.") + column +
           " FROM attempts x WHERE x.account_id = g.account_id AND x.task_id = g.task_id AND " +
           is_finished("x") + " ORDER BY x.started_utc DESC, x.id DESC LIMIT 1 OFFSET " +
           std::to_string(number - 1) + "), " + none + ")";
}

/// The last outcomes of each, oldest first.
std::map<Key, std::vector<assessment::TrialOutcome>> read_last(Connection& connection,
                                                               const AttemptConditions& where) {
    const int n = assessment::kStuckTrials;
    // Materialized: PostgreSQL would look for the beginning again for every attempt.
    Statement query(
        connection,
        "WITH f AS MATERIALIZED (SELECT g.account_id, g.task_id, " +
            from_the_end("started_utc", n, "''") + " AS from_utc, " + from_the_end("id", n, "0") +
            " AS from_id FROM (SELECT t.account_id, t.task_id FROM attempts t" + finished(where) +
            " GROUP BY t.account_id, t.task_id) g) SELECT f.account_id, f.task_id, x.points, "
            "x.verdict FROM f JOIN attempts x ON x.account_id = f.account_id AND x.task_id = "
            "f.task_id AND " +
            is_finished("x") +
            " AND (x.started_utc, x.id) >= (f.from_utc, f.from_id) ORDER BY "
            "f.account_id, f.task_id, x.started_utc, x.id");
    query.run_list(where.values);
    std::map<Key, std::vector<assessment::TrialOutcome>> last;
    while (query.next())
        last[{query.integer(0), query.text(1)}].push_back(
            {query.real(2),
             static_cast<assessment::Verdict>(query.integer(3)) == assessment::Verdict::kPassed});
    return last;
}

/// What sums do not tell, asked for the few of whom it matters.
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
        for (auto each = last.rbegin(); each != last.rend() && each->passed; ++each)
            ++trials.streak;
        const bool all = trials.streak == static_cast<int>(last.size());
        if (trials.attempts <= static_cast<int>(last.size())) return;
        double best = 0;
        for (const assessment::TrialOutcome& each : last) best = std::max(best, each.points);
        // The best of all lies before the last ones, or passed among them: nothing more to ask.
        trials.best_before = trials.best;
        const bool passed =
            std::any_of(last.begin(), last.end(), [](const auto& each) { return each.passed; });
        if (!all && (passed || best < trials.best)) return;
        outcomes_.run(one.user_id, one.task_id);
        std::vector<assessment::TrialOutcome> every;
        while (outcomes_.next())
            every.push_back({outcomes_.real(0), static_cast<assessment::Verdict>(outcomes_.integer(
                                                    1)) == assessment::Verdict::kPassed});
        trials = assessment::summarise_trials(every);
    }

 private:
    Statement outcomes_;
};

}  // namespace

std::vector<TaskStanding> SqlStore::task_standings(int64_t group_id, const std::string& task_id) {
    connection_.begin_operation("sum up attempts of");
    const AttemptConditions where = conditions_of(0, group_id, task_id);
    std::vector<TaskStanding> found = read_sums(connection_, where);
    auto last = read_last(connection_, where);
    Closer closer(connection_);
    for (TaskStanding& one : found) {
        one.trials.last = std::move(last[{one.user_id, one.task_id}]);
        closer.complete(one);
    }
    return found;
}

std::vector<std::string> SqlStore::tasks_with_attempts() {
    connection_.begin_operation("list tasks of");
    // From one name to the next over the index: SELECT DISTINCT reads every attempt.
    Statement next(connection_, "SELECT MIN(task_id) FROM attempts WHERE task_id > ?");
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

std::vector<RecentMean> SqlStore::recent_means(const std::string& task_id, int last) {
    // Before the question: PostgreSQL answers one at a time.
    std::map<int64_t, std::string> names;
    for (const UserRecord& user : users()) names[user.id] = user.display_name;
    connection_.begin_operation("read scores from");
    const auto script = [](const std::string& table) {
        return "CASE WHEN " + table + ".device LIKE 'script:%' THEN " + table +
               ".device ELSE '' END";
    };
    Statement query(connection_,
                    "SELECT g.account_id, g.script, g.n, g.demonstration, (SELECT AVG(few.points) "
                    "FROM (SELECT x.points FROM attempts x WHERE x.account_id = g.account_id AND "
                    "x.task_id = ? AND " +
                        is_finished("x") + " AND " + script("x") +
                        " = g.script ORDER BY x.started_utc DESC, x.id DESC LIMIT ?) AS few) FROM "
                        "(SELECT t.account_id, " +
                        script("t") +
                        " AS script, COUNT(*) AS n, MAX(t.demonstration) AS demonstration FROM "
                        "attempts t WHERE t.task_id = ? AND " +
                        is_finished("t") + " GROUP BY t.account_id, " + script("t") + ") g");
    query.run(task_id, int64_t{last}, task_id);
    std::vector<RecentMean> found;
    while (query.next()) {
        RecentMean one;
        one.user_id = query.integer(0);
        one.user_name = names[one.user_id];
        one.script = query.text(1);
        one.attempts = static_cast<int>(query.integer(2));
        one.demonstration = query.integer(3) != 0;
        one.mean_points = query.real(4);
        found.push_back(std::move(one));
    }
    std::stable_sort(found.begin(), found.end(), [](const RecentMean& a, const RecentMean& b) {
        return std::tie(a.user_name, a.user_id, a.script) <
               std::tie(b.user_name, b.user_id, b.script);
    });
    return found;
}

}  // namespace placode::db

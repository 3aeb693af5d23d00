// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a store says of a cohort and of one trainee, joined by person and task.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "db/attempt_counting.h"
#include "reports/cohort_report.h"

namespace placode::reports {
namespace {

/// By the rule of the cohort page. @pre points and failed are filled.
void judge(PersonInTask& one) {
    std::vector<assessment::TrialOutcome> outcomes;
    for (size_t i = 0; i < one.points.size(); ++i)
        outcomes.push_back({one.points[i], !one.failed[i]});
    one.standing_now = assessment::judge_standing(outcomes);
}

/// Joins sums and curves of the same people.
std::vector<PersonInTask> people_in_tasks(const std::vector<db::TaskStanding>& standings,
                                          const std::vector<db::AttemptPoint>& points) {
    std::map<std::pair<int64_t, std::string>, size_t> places;
    std::vector<PersonInTask> people;
    for (const db::TaskStanding& standing : standings) {
        places[{standing.user_id, standing.task_id}] = people.size();
        people.push_back({standing, {}, {}, {}});
    }
    for (const db::AttemptPoint& point : points) {
        const auto place = places.find({point.user_id, point.task_id});
        if (place == places.end()) continue;
        people[place->second].points.push_back(point.points);
        people[place->second].failed.push_back(point.verdict != assessment::Verdict::kPassed);
    }
    for (PersonInTask& one : people) judge(one);
    return people;
}

}  // namespace

CohortReport read_cohort_report(db::Store& store, int64_t group_id, const std::string& now_utc) {
    CohortReport report;
    report.made_utc = now_utc;
    report.group = "everybody";
    if (group_id != 0) {
        report.group.clear();
        for (const db::GroupRecord& group : store.groups().list())
            if (group.id == group_id) report.group = group.name;
        if (report.group.empty())
            throw db::StoreError(db::StoreError::Kind::kNotFound,
                                 "there is no group " + std::to_string(group_id));
    }
    const std::vector<db::AttemptPoint> points = store.attempts().points(group_id);
    report.people = people_in_tasks(store.attempts().standings(group_id), points);
    std::vector<JudgedAttempt> judged;
    judged.reserve(points.size());
    for (const db::AttemptPoint& point : points)
        judged.push_back({point.task_id, point.task_version, point.started_utc});
    report.pass_marks = pass_marks_of(store, judged);
    std::set<int64_t> demonstrators;
    for (const db::UserRecord& user : store.accounts().list())
        if (user.demonstration) demonstrators.insert(user.id);
    report.demonstration = std::any_of(
        report.people.begin(), report.people.end(),
        [&](const PersonInTask& one) { return demonstrators.contains(one.standing.user_id); });
    return report;
}

TraineeReport read_trainee_report(db::Store& store, const db::UserRecord& user,
                                  const std::string& now_utc) {
    TraineeReport report;
    report.user = user;
    report.made_utc = now_utc;
    report.courses = db::course_standings(store, user.id, now_utc);
    report.attempts = store.attempts().list(user.id);
    std::map<std::string, PersonInTask> tasks;
    std::vector<JudgedAttempt> judged;
    for (const db::AttemptRecord& attempt : report.attempts) {
        if (!db::counts(attempt)) continue;
        judged.push_back({attempt.task_id, attempt.task_version, attempt.started_utc});
        PersonInTask& one = tasks[attempt.task_id];
        auto& s = one.standing;
        s.user_id = user.id;
        s.user_name = user.display_name;
        s.task_id = attempt.task_id;
        s.last_points = attempt.points;
        s.last_utc = attempt.started_utc;
        s.best_points =
            one.points.empty() ? attempt.points : std::max(s.best_points, attempt.points);
        s.mean_points = (s.mean_points * s.attempts + attempt.points) / (s.attempts + 1);
        ++s.attempts;
        s.failed += attempt.verdict == assessment::Verdict::kFailed ? 1 : 0;
        one.points.push_back(attempt.points);
        one.failed.push_back(attempt.verdict != assessment::Verdict::kPassed);
    }
    report.pass_marks = pass_marks_of(store, judged);
    for (auto& [task, one] : tasks) {
        judge(one);
        report.tasks.push_back(std::move(one));
    }
    return report;
}

}  // namespace placode::reports

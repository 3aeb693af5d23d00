// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/course_rows.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/attempt_rows.h"
#include "db/store_context.h"

namespace placode::db {

using curriculum::Course;
using curriculum::CourseStage;

namespace {

std::vector<AttemptRecord> attempts_of(Connection& connection, int64_t user_id) {
    const AttemptConditions where = conditions_of(user_id, 0, {});
    Statement query(connection, attempt_columns() + where.sql + " ORDER BY t.started_utc, t.id");
    query.run_list(where.values);
    std::vector<AttemptRecord> found;
    while (query.next()) found.push_back(read_attempt(query));
    return found;
}

/// As far as a standing needs them.
std::vector<GrantRecord> grants_of(Connection& connection, int64_t user_id) {
    Statement query(connection,
                    "SELECT course_id, stage_id, attempts FROM course_grants WHERE account_id = ?");
    query.run(user_id);
    std::vector<GrantRecord> found;
    while (query.next()) {
        GrantRecord grant;
        grant.user_id = user_id;
        grant.course_id = query.text("course_id");
        grant.stage_id = query.text("stage_id");
        grant.attempts = static_cast<int>(query.integer("attempts"));
        found.push_back(std::move(grant));
    }
    return found;
}

/// The one that holds; id 0 = none.
AssignmentRecord assignment_of(Connection& connection, int64_t user_id,
                               const std::string& course_id, const std::string& now_utc) {
    Statement query(
        connection,
        "SELECT id, course_version, COALESCE(account_id, 0) AS for_user, COALESCE(group_id, 0) AS "
        "for_group, starts_utc, due_utc FROM course_assignments WHERE course_id = ? AND ended_utc "
        "= '' AND (account_id = ? OR group_id IN (SELECT group_id FROM group_members WHERE "
        "account_id = ? AND teaches = 0)) ORDER BY id");
    query.run(course_id, user_id, user_id);
    std::vector<AssignmentRecord> all;
    while (query.next()) {
        AssignmentRecord& found = all.emplace_back();
        found.id = query.integer("id");
        found.course_id = course_id;
        found.course_version = static_cast<int>(query.integer("course_version"));
        found.user_id = query.integer("for_user");
        found.group_id = query.integer("for_group");
        found.starts_utc = query.text("starts_utc");
        found.due_utc = query.text("due_utc");
    }
    all = held_assignments(std::move(all), now_utc);
    return all.empty() ? AssignmentRecord{} : all.front();
}

Course course_of(StoreContext& context, const std::string& id, int version) {
    if (const auto published = context.find_definition("course", id, version))
        return curriculum::load_published_course(published->json, "course " + id);
    const auto shipped = curriculum::shipped_text("courses", id);
    return shipped ? curriculum::load_course_text(*shipped, "course " + id) : Course{};
}

/// By due date, open-ended ones last.
auto due_order(const AssignmentRecord& a) { return std::tuple(a.due_utc.empty(), a.due_utc, a.id); }

}  // namespace

std::vector<AssignmentRecord> held_assignments(std::vector<AssignmentRecord> assignments,
                                               const std::string& now_utc) {
    const auto now = curriculum::utc_seconds(now_utc);
    // What begins later locks nobody out of what runs; whom an educator gave dates of their own
    // has those.
    const auto order = [&](const AssignmentRecord& a) {
        const auto starts = curriculum::utc_seconds(a.starts_utc);
        const bool later = now && starts && *now < *starts;
        return std::tuple(later ? *starts : 0, a.user_id == 0, due_order(a));
    };
    std::sort(assignments.begin(), assignments.end(),
              [&](const auto& a, const auto& b) { return order(a) < order(b); });
    std::set<std::string> seen;
    std::erase_if(assignments,
                  [&](const auto& each) { return !seen.insert(each.course_id).second; });
    std::sort(assignments.begin(), assignments.end(),
              [](const auto& a, const auto& b) { return due_order(a) < due_order(b); });
    return assignments;
}

std::vector<AttemptRecord> own_attempts(std::vector<AttemptRecord> attempts, bool demonstration) {
    if (demonstration) return attempts;
    const auto shown = [](const AttemptRecord& each) {
        return each.demonstration || each.generated;
    };
    std::erase_if(attempts, [&shown](const AttemptRecord& each) {
        return shown(each) && each.exam.course_id.empty();
    });
    // An exam's case was seen: it is used up, and not met.
    for (AttemptRecord& each : attempts)
        if (shown(each)) each.end = sim::EndReason::kInterrupted;
    return attempts;
}

curriculum::CourseProgress progress_in(const Course& course, const CourseRows& rows,
                                       const std::string& now_utc) {
    curriculum::ExtraAttempts extra;
    for (const GrantRecord& grant : rows.grants)
        if (grant.course_id == course.id) extra[grant.stage_id] += grant.attempts;
    return curriculum::course_progress(course, outcomes_of(rows.attempts, rows.begins), now_utc,
                                       extra);
}

CourseRows course_rows(StoreContext& context, const UserRecord& user) {
    return {own_attempts(attempts_of(context.connection, user.id), user.demonstration),
            begins_of(context.connection, user.id), grants_of(context.connection, user.id)};
}

CourseStanding standing_from(StoreContext& context, const std::string& course_id, int64_t user_id,
                             const CourseRows& rows, const std::string& now_utc) {
    CourseStanding standing;
    standing.assignment = assignment_of(context.connection, user_id, course_id, now_utc);
    standing.course = course_of(context, course_id, standing.assignment.course_version);
    standing.progress = progress_in(standing.course, rows, now_utc);
    standing.next = curriculum::next_step(
        standing.course, standing.progress, {},
        {standing.assignment.starts_utc, standing.assignment.due_utc}, now_utc);
    return standing;
}

std::optional<Said> why_no_exam(const CourseStanding& standing, const std::string& stage_id) {
    const CourseStage* stage = standing.course.stage(stage_id);
    if (stage == nullptr || stage->mode != curriculum::StageMode::kExam)
        return Said::that("the course has no such exam stage");
    if (standing.assignment.id == 0) return Said::that("the course is not assigned to this person");
    if (standing.next.kind == curriculum::NextKind::kWait) return Said::as_is(standing.next.reason);
    const curriculum::StageProgress& own = progress_of(standing, stage_id);
    if (own.status == curriculum::StageStatus::kLocked)
        return Said::that("locked; to be mastered first: %1").with(own.missing.front());
    if (own.status == curriculum::StageStatus::kExhausted)
        return Said::that("all attempts are used");
    return std::nullopt;
}

const curriculum::StageProgress& progress_of(const CourseStanding& standing,
                                             const std::string& stage_id) {
    const auto at = standing.course.stage(stage_id) - standing.course.stages.data();
    return standing.progress.stages[static_cast<size_t>(at)];
}

int newest_task_version(StoreContext& context, const std::string& task_id) {
    const auto published = context.find_definition("task", task_id, 0);
    const auto shipped = curriculum::shipped_task(task_id);
    return std::max(published ? published->version : 0, shipped ? shipped->version : 0);
}

std::string clock_of_store(Connection& connection) {
    if (connection.is_sqlite()) return utc_now();
    Statement query(connection,
                    "SELECT to_char(clock_timestamp() AT TIME ZONE 'UTC', "
                    "'YYYY-MM-DD\"T\"HH24:MI:SS.MS\"Z\"')");
    return query.run().next() ? query.text(0) : utc_now();
}

std::vector<ExamBeginRecord> begins_of(Connection& connection, int64_t user_id) {
    Statement query(connection,
                    "SELECT b.id, b.course_id, b.course_version, b.stage_id, b.task_id, "
                    "b.task_version, b.seed, b.proctor, b.device_certificate, b.begun_utc, "
                    "COALESCE(t.id, 0) AS attempt FROM exam_begins b LEFT JOIN attempts t ON "
                    "t.account_id = b.account_id AND t.exam_begin = b.id AND t.exam_begin <> 0 "
                    "WHERE b.account_id = ? ORDER BY "
                    "b.begun_utc, b.id");
    query.run(user_id);
    std::vector<ExamBeginRecord> found;
    while (query.next()) {
        ExamBeginRecord begin;
        begin.id = query.integer("id");
        begin.user_id = user_id;
        begin.course_id = query.text("course_id");
        begin.course_version = static_cast<int>(query.integer("course_version"));
        begin.stage_id = query.text("stage_id");
        begin.task_id = query.text("task_id");
        begin.task_version = static_cast<int>(query.integer("task_version"));
        const std::string seed = query.text("seed");
        std::from_chars(seed.data(), seed.data() + seed.size(), begin.seed);
        begin.proctor = query.text("proctor");
        begin.device_certificate = query.text("device_certificate");
        begin.begun_utc = query.text("begun_utc");
        begin.attempt_id = query.integer("attempt");
        found.push_back(std::move(begin));
    }
    return found;
}

void lock_exams(Connection& connection, int64_t user_id) {
    connection.lock_table("exams of " + std::to_string(user_id));
}

}  // namespace placode::db

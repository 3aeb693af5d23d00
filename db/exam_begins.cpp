// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Exams as they begin: what is asked is asked again in the transaction that writes the begin, so
// that two stations cannot begin the last attempt both.

#include <cstdlib>

#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/audit_check.h"
#include "db/course_rows.h"
#include "db/courses.h"
#include "db/exam_check.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// The number of the account that is proctor, "user 12"; empty where none is named.
std::string kept_proctor(StoreContext& context, const std::string& name, int64_t examinee) {
    if (name.empty()) return {};
    const auto proctor = context.find_staff(name);
    if (!proctor)
        context.connection.fail(
            Kind::kRefused,
            Said::that("\"%1\" is no active educator or administrator and cannot be the proctor")
                .with(name));
    if (proctor->id == examinee)
        context.connection.fail(Kind::kRefused, Said::that("nobody can be their own proctor"));
    return user_object(proctor->id);
}

/// The simulator of this program would perform another text of the task than the one that counts.
void need_newest_task(StoreContext& context, const std::string& task_id, int newest) {
    const auto shipped = curriculum::shipped_task(task_id);
    if (shipped && shipped->version < newest)
        context.connection.fail(Kind::kRefused,
                                Said::that("version %1 of its task is published, and this program "
                                           "has version %2; update Placode")
                                    .with(newest)
                                    .with(shipped->version));
}

/// What would make the exam void is said before it is performed.
void need_sound_station(StoreContext& context, const std::string& now_utc) {
    const auto here = curriculum::utc_seconds(utc_now()), there = curriculum::utc_seconds(now_utc);
    if (here && there && std::abs(*here - *there) > kClockAllowanceS)
        context.connection.fail(Kind::kRefused,
                                Said::that("the clocks of this computer and of the server differ; "
                                           "an administrator sets them"));
    if (!is_trusted_station(context, context.station.public_key()))
        context.connection.fail(
            Kind::kRefused,
            Said::that("nobody has vouched for this computer, so an exam would not count; an "
                       "administrator does: placodectl station trust"));
}

}  // namespace

int64_t Courses::begin_exam(int64_t user_id, const ExamOrder& order) {
    const ExamContext& exam = order.context;
    connection_.begin_operation("begin the exam " + exam.course_id + "/" + exam.stage_id + " in");
    context_.need_for(Action::kPerformAttempt, user_id);
    UnitOfWork work(connection_);
    lock_exams(connection_, user_id);
    const UserRecord user = context_.need_owner(user_id);
    const std::string now = clock_of_store(connection_);
    need_sound_station(context_, now);
    const CourseStanding standing =
        standing_from(context_, exam.course_id, user_id, course_rows(context_, user), now);
    if (const auto problem = why_no_exam(standing, exam.stage_id))
        connection_.fail(Kind::kRefused, *problem);
    const curriculum::CourseStage& stage = *standing.course.stage(exam.stage_id);
    if (standing.course.version != exam.course_version || stage.task_id != order.task_id ||
        progress_of(standing, exam.stage_id).next_seed != order.seed)
        connection_.fail(Kind::kConflict,
                         Said::that("another case is due by now; open the exam again"));
    if (stage.exam.proctor && exam.proctor.empty())
        connection_.fail(Kind::kRefused, Said::that("the proctor's name is missing"));
    if (stage.exam.haptic_certificate && exam.device_certificate.empty())
        connection_.fail(Kind::kRefused, Said::that("the device has no haptic certificate"));
    const std::string proctor = kept_proctor(context_, exam.proctor, user_id);
    const int task_version = newest_task_version(context_, order.task_id);
    need_newest_task(context_, order.task_id, task_version);
    context_.touch("user", user_id);
    const int64_t id =
        Statement(connection_,
                  "INSERT INTO exam_begins (account_id, course_id, course_version, stage_id, "
                  "task_id, task_version, seed, proctor, device_certificate, begun_utc) VALUES "
                  "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id")
            .run(user_id, exam.course_id, exam.course_version, exam.stage_id, order.task_id,
                 task_version, std::to_string(order.seed), proctor, exam.device_certificate, now)
            .returned_id();
    context_.append_audit("exam.begin", exam.course_id + "/" + exam.stage_id,
                          proctor.empty() ? std::string() : "proctor " + proctor);
    work.commit();
    return id;
}

std::vector<ExamBeginRecord> Courses::exam_begins(int64_t user_id) {
    connection_.begin_operation("list the exams that were begun in");
    context_.need_for(Action::kViewAttempts, user_id);
    return begins_of(connection_, user_id);
}

}  // namespace placode::db

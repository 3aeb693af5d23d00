// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/training.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <map>

#include "db/course_conduct.h"

namespace placode::ui {

QString Training::taskTitle(const AppContext& context, const std::string& task_id) const {
    for (const TrainingStage& stage : stages) {
        if (stage.task_id == task_id && stage.task) return context.in(stage.task->title);
    }
    return QString::fromStdString(task_id);
}

namespace {

std::string utc_now() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

/// A computer is shared: what one trainee looked at is no other's choice.
QString course_key(const AppContext& context) {
    return QString("course/%1").arg(context.user().id);
}

/// The assigned course that has something to do now, by due date; empty = none has.
std::string course_to_do(AppContext& context) {
    std::string found;
    // One that cannot be read is said where it is opened.
    (void)context.problemOf([&] {
        for (const db::CourseStanding& each :
             db::course_standings(context.store(), context.user().id, utc_now())) {
            if (each.next.kind == curriculum::NextKind::kFinished ||
                each.next.kind == curriculum::NextKind::kWait)
                continue;
            found = each.course.id;
            return;
        }
    });
    return found;
}

}  // namespace

std::vector<std::string> course_ids(AppContext& context) {
    std::vector<std::string> ids;
    const auto add = [&](const std::string& id) {
        if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    };
    for (const auto& each : context.store().courses().assignments(context.user().id))
        add(each.course_id);
    const size_t assigned = ids.size();
    for (const std::string& id : db::course_ids(context.store())) add(id);
    if (ids.empty()) {
        throw curriculum::DefinitionError((curriculum::data_folder() / "courses").string(), "",
                                          "no course found; expected at least one .json file");
    }
    std::string first = context.storeSetting(course_key(context)).toString().toStdString();
    if (first.empty() && assigned > 1) first = course_to_do(context);
    const auto found = std::find(ids.begin(), ids.end(), first);
    if (found != ids.end()) std::rotate(ids.begin(), found, found + 1);
    return ids;
}

void choose_course(AppContext& context, const QString& id) {
    context.setStoreSetting(course_key(context), id);
}

Training load_training(AppContext& context, const std::string& course) {
    Training training;
    db::CourseStanding standing =
        db::course_standing(context.store(), context.user().id,
                            course.empty() ? course_ids(context).front() : course, utc_now());
    training.attempts = context.store().attempts().list(context.user().id);
    training.course = std::move(standing.course);
    training.next = std::move(standing.next);
    training.next_stage = training.next.stage;
    const curriculum::CourseProgress& progress = standing.progress;
    training.mastered = progress.mastered;
    training.certificate = standing.certificate;
    for (size_t i = 0; i < training.course.stages.size(); ++i) {
        TrainingStage stage;
        stage.rule = training.course.stages[i];
        stage.task_id = stage.rule.task_id;
        stage.progress = progress.stages[i];
        stage.problem =
            context.problemOf([&] { stage.task = curriculum::load_task(stage.rule.task_id); });
        training.stages.push_back(std::move(stage));
    }
    return training;
}

void require_sight(AppContext& context, const db::AttemptRecord& attempt) {
    if (!attempt.study.study.empty() && context.may(db::Action::kRunQuestionnaire)) return;
    const bool own = attempt.user_id == context.user().id;
    context.require(db::Action::kViewAttempts, own ? db::Scope::kOwn : db::Scope::kOther);
}

namespace {

constexpr size_t kRemarkedAttempts = 30;
constexpr int kRemarksDays = 14;

/// Id of the last remark that was read.
QString read_key(const AppContext& context, int64_t attempt_id) {
    return QString("remarks_read/%1/%2").arg(context.user().id).arg(attempt_id);
}

}  // namespace

NewRemarks new_remarks(AppContext& context, const std::vector<db::AttemptRecord>& own) {
    NewRemarks found;
    std::string newest;
    const QDateTime since = QDateTime::currentDateTimeUtc().addDays(-kRemarksDays);
    const size_t from = own.size() > kRemarkedAttempts ? own.size() - kRemarkedAttempts : 0;
    std::map<int64_t, qlonglong> read;
    std::vector<int64_t> ids;
    for (size_t i = from; i < own.size(); ++i) {
        ids.push_back(own[i].id);
        read[own[i].id] = context.storeSetting(read_key(context, own[i].id)).toLongLong();
    }
    for (const db::CommentRecord& each : context.store().reviews().comments_of(ids)) {
        if (each.author_id == context.user().id || each.id <= read[each.attempt_id]) continue;
        const auto at = QDateTime::fromString(QString::fromStdString(each.at_utc), Qt::ISODate);
        if (at < since) continue;
        ++found.count;
        if (each.at_utc < newest) continue;
        newest = each.at_utc;
        found.attempt_id = each.attempt_id;
    }
    return found;
}

void remarks_read(AppContext& context, int64_t attempt_id,
                  const std::vector<db::CommentRecord>& comments) {
    int64_t last = 0;
    for (const db::CommentRecord& each : comments) last = std::max(last, each.id);
    if (last > 0)
        context.setStoreSetting(read_key(context, attempt_id), static_cast<qlonglong>(last));
}

QVariantMap task_state(const curriculum::Course& course, const curriculum::CourseStage& stage) {
    if (stage.mode != curriculum::StageMode::kExam) return {};
    return {{"exam_course", QString::fromStdString(course.id)},
            {"exam_stage", QString::fromStdString(stage.id)}};
}

QString task_title(AppContext& context, const std::string& task_id) {
    QString title = QString::fromStdString(task_id);
    // A history may hold tasks that no longer ship: their id is title enough.
    (void)context.problemOf([&] { title = context.in(curriculum::load_task_title(task_id)); });
    return title;
}

QString stage_title(AppContext& context, const std::string& task_id, int stage) {
    QString title = QCoreApplication::translate("ResultPage", "stage %1").arg(stage);
    (void)context.problemOf([&] {
        const curriculum::Task task = curriculum::load_task(task_id);
        title = context.in(curriculum::stage_of(task, stage).title);
    });
    return title;
}

reports::TaskScope task_scope(AppContext& context, const std::string& task_id) {
    reports::TaskScope scope;
    (void)context.problemOf([&] { scope = reports::scope_of(curriculum::load_task(task_id)); });
    return scope;
}

}  // namespace placode::ui

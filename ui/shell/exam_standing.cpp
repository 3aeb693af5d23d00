// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/exam_standing.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

using curriculum::StageStatus;

struct ExamStandingWords {
    Q_DECLARE_TR_FUNCTIONS(ExamStandingWords)
};

using Begins = std::vector<db::ExamBeginRecord>;

/// @param begins of exams of the person.
curriculum::AttemptOutcome outcome_of(const db::AttemptRecord& attempt, const Begins& begins) {
    // Of the others one that nothing ended would be an outcome, too.
    Begins own;
    std::copy_if(begins.begin(), begins.end(), std::back_inserter(own),
                 [&](const auto& begin) { return begin.attempt_id == attempt.id; });
    return db::outcomes_of({attempt}, own).front();
}

/// Whether the machine spoilt one of this exam before: the first one is given back by itself.
bool given_back_before(AppContext& context, const db::AttemptRecord& attempt,
                       const Begins& begins) {
    const auto all = context.store().attempts().list(attempt.user_id, attempt.task_id);
    return std::any_of(all.begin(), all.end(), [&](const db::AttemptRecord& each) {
        return each.exam.course_id == attempt.exam.course_id &&
               each.exam.stage_id == attempt.exam.stage_id &&
               std::pair(each.started_utc, each.id) < std::pair(attempt.started_utc, attempt.id) &&
               outcome_of(each, begins).voided;
    });
}

/// Left and idle attempts as well: the case was seen.
bool uses_up(AppContext& context, const curriculum::Course& course,
             const curriculum::CourseStage& stage, const curriculum::StageProgress& progress,
             const db::AttemptRecord& attempt, const Begins& begins) {
    curriculum::AttemptOutcome outcome = outcome_of(attempt, begins);
    if (outcome.voided) outcome.voided = !given_back_before(context, attempt, begins);
    outcome.interrupted = false;
    const std::string& mastered = progress.mastered_utc;
    if (!mastered.empty() && outcome.at_utc > mastered) return false;  // A repetition is free.
    return curriculum::counts_for(course, stage, outcome);
}

QString used_words(const curriculum::StageProgress& own, bool used) {
    if (own.attempts_left < 0)
        return ExamStandingWords::tr("The number of attempts at this exam is not limited.");
    const QString left = own.attempts_left == 0
                             ? ExamStandingWords::tr("none is left")
                             : ExamStandingWords::tr("left: %1").arg(own.attempts_left);
    return (used ? ExamStandingWords::tr("It uses up one of the %1 attempts at this exam; %2.")
                 : ExamStandingWords::tr("It uses up none of the %1 attempts at this exam; %2."))
        .arg(own.limited + own.attempts_left)
        .arg(left);
}

QString next_words(AppContext& context, const db::CourseStanding& standing,
                   const curriculum::CourseStage& stage, const curriculum::StageProgress& own) {
    switch (own.status) {
        case StageStatus::kMastered:
            if (standing.progress.mastered)
                return ExamStandingWords::tr(
                    "The exam is passed, and with it the course: the certificate is on the page "
                    "Course.");
            if (standing.next.stage < 0) return ExamStandingWords::tr("The exam is passed.");
            return ExamStandingWords::tr("The exam is passed. Next in the course: %1.")
                .arg(task_title(context, standing.next.task_id));
        case StageStatus::kExhausted:
            return ExamStandingWords::tr(
                "The exam is not passed. An educator can grant more "
                "attempts.");
        default:
            if (own.streak > 0 && own.streak < stage.consecutive)
                return ExamStandingWords::tr(
                           "To pass, the benchmark is still to be met in a row: %1 times.")
                    .arg(stage.consecutive - own.streak);
            return stage.exam.seeds.size() > 1
                       ? ExamStandingWords::tr("The next attempt at this exam has another case.")
                       : ExamStandingWords::tr("The next attempt at this exam has the same case.");
    }
}

}  // namespace

ExamStanding exam_standing(AppContext& context, const db::AttemptRecord& attempt) {
    ExamStanding found;
    std::optional<db::CourseStanding> standing;
    Begins begins;
    const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    // A course that is gone leaves the attempt: its result is shown without this.
    (void)context.problemOf([&] {
        standing =
            db::course_standing(context.store(), attempt.user_id, attempt.exam.course_id, now);
        begins = context.store().courses().exam_begins(attempt.user_id);
    });
    if (!standing) return found;
    const curriculum::CourseStage* stage = standing->course.stage(attempt.exam.stage_id);
    if (stage == nullptr) return found;
    const auto& own =
        standing->progress.stages[static_cast<size_t>(stage - standing->course.stages.data())];
    found.used = uses_up(context, standing->course, *stage, own, attempt, begins);
    found.words = used_words(own, found.used) + " " + next_words(context, *standing, *stage, own);
    if (db::counts(attempt))
        found.words.prepend(ExamStandingWords::tr("The attempt counts.") + " ");
    return found;
}

}  // namespace placode::ui

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/result_standing.h"

#include <QCoreApplication>
#include <QProgressBar>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

#include "curriculum/attempt_runner.h"
#include "db/attempt_counting.h"
#include "db/evidence.h"
#include "db/void_reason.h"
#include "reports/words.h"
#include "ui/shell/day_text.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct StandingText {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
};

}  // namespace

bool waits_for_replay(const db::AttemptRecord& record) {
    return record.replay == db::ReplayState::kWaiting && db::was_tried(record) &&
           record.void_reason.empty();
}

bool can_be_replayed_here(const db::AttemptRecord& record) {
    return record.build == curriculum::this_build();
}

QString why_not_counted(const db::AttemptRecord& record, const ExamStanding& standing, bool own) {
    QStringList said;
    const bool exam = !record.exam.course_id.empty();
    if (waits_for_replay(record) && !can_be_replayed_here(record)) {
        said << StandingText::tr(
            "It was recorded by another version of Placode, or on another kind of processor, and "
            "can be simulated again only there. Until that is done it does not count.");
        if (const std::string build = db::build_waited_for(record); !build.empty())
            said << StandingText::tr("It waits for \"%1\"; this is \"%2\".")
                        .arg(qstr(build), qstr(curriculum::this_build()));
        return said.join(' ');
    }
    if (waits_for_replay(record))
        return StandingText::tr(
            "What the hands did is simulated again, behind other work. The attempt gets "
            "its score and counts once the same comes out.");
    if (!record.void_reason.empty()) {
        // Of an exam also the force device; its reasons are figures for technicians.
        const bool device = exam && record.haptic_grade == "bad";
        const QString reason = reports::void_words(record.void_reason, record.void_meaning);
        said << (device ? StandingText::tr("The force device did not work as it must (%1).")
                        : StandingText::tr("%1."))
                    .arg(reason);
        if (db::machine_at_fault(record))
            said << (own ? StandingText::tr("This was not your fault.")
                         : StandingText::tr("The machine was the cause, not the person."));
        const auto reasons = db::why_void(record);
        if (std::any_of(reasons.begin(), reasons.end(), [](const db::VoidReason& reason) {
                return reason.cause == db::VoidCause::kFewPictures ||
                       reason.cause == db::VoidCause::kNotRealTime;
            }))
            said << StandingText::tr(
                "Close other programs, make the window of the simulation smaller, or "
                "use another computer.");
    }
    if (exam && !standing.words.isEmpty())
        said << StandingText::tr("The attempt is kept.") << standing.words;
    else if (exam)
        said << (record.void_reason.empty()
                     ? StandingText::tr("The attempt is kept, and uses up an attempt of this exam.")
                     : StandingText::tr(
                           "The attempt is kept, and uses up no attempt of this exam; the next "
                           "one has another case, if there is one."));
    else
        said << StandingText::tr("The attempt is kept, and does not count for the course.");
    return said.join(' ');
}

namespace {

/// Empty where the course lacks the task, or has it as an exam only.
QString words_in(AppContext& context, const Training& training, const db::AttemptRecord& record) {
    for (const TrainingStage& stage : training.stages) {
        if (stage.task_id != record.task_id || stage.rule.mode == curriculum::StageMode::kExam)
            continue;
        QString words;
        if (stage.progress.status == curriculum::StageStatus::kMastered)
            // Of an earlier attempt, where this one failed: else praise heads a failure.
            words =
                (record.verdict == assessment::Verdict::kFailed
                     ? StandingText::tr("This attempt failed; mastered in the course before: %1.")
                     : StandingText::tr("Mastered in the course: %1."))
                    .arg(training.taskTitle(context, stage.task_id)) +
                " ";
        return words + with_day_words(context.in(training.next.reason));
    }
    return {};
}

}  // namespace

QString course_words(AppContext& context, const db::AttemptRecord& record) {
    QString words;
    // A course that cannot be read leaves the result as it is.
    (void)context.problemOf([&] {
        // The page Today is about another one as soon as this attempt has finished the course.
        std::vector<std::string> ids{course_ids(context).front()};
        for (const auto& each : context.store().courses().assignments(context.user().id))
            if (each.course_id != ids.front()) ids.push_back(each.course_id);
        for (const std::string& id : ids) {
            const Training training = load_training(context, id);
            for (const db::AttemptRecord& each : training.attempts)
                if (each.id > record.id && db::counts(each)) return;
            words = words_in(context, training, record);
            if (!words.isEmpty()) return;
        }
    });
    return words;
}

QWidget* make_replay_bar(AppContext& context, int64_t attempt_id) {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    QLabel* words = make_label({}, "small");
    words->setObjectName("replay_share");
    auto* bar = new QProgressBar;
    bar->setObjectName("replay_progress");
    bar->setAccessibleName(StandingText::tr("Simulated again"));
    bar->setRange(0, 100);
    bar->setTextVisible(false);  // it is thinner than a line of text
    column->addWidget(words);
    column->addWidget(bar);
    const auto show = [&context, bar, words, attempt_id] {
        const int share = static_cast<int>(100 * context.replays().share(attempt_id).value_or(0));
        bar->setValue(share);
        words->setText(StandingText::tr("Simulated again: %1 %").arg(share));
    };
    show();
    QObject::connect(&context.replays(), &ReplayQueue::moved, box, show);
    context.verifyAttempts();
    return box;
}

}  // namespace placode::ui

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/course_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct CourseWords {
    Q_DECLARE_TR_FUNCTIONS(CourseWords)
};

}  // namespace

QString mode_word(curriculum::StageMode mode) {
    switch (mode) {
        case curriculum::StageMode::kFamiliarisation:
            return CourseWords::tr("Familiarisation");
        case curriculum::StageMode::kExam:
            return CourseWords::tr("Exam");
        default:
            return CourseWords::tr("Practice");
    }
}

QString stage_rule_words(const curriculum::CourseStage& stage) {
    QStringList parts;
    parts << (stage.mode == curriculum::StageMode::kFamiliarisation && stage.benchmark_points <= 0
                  ? CourseWords::tr("Counts whatever the score")
              : stage.consecutive == 1
                  ? CourseWords::tr("Benchmark %n point(s), once", nullptr,
                                    whole_points(stage.benchmark_points))
                  : CourseWords::tr("Benchmark %n point(s), %1 times in a row", nullptr,
                                    whole_points(stage.benchmark_points))
                        .arg(stage.consecutive));
    if (stage.max_attempts > 0)
        parts << CourseWords::tr("attempts at most: %1").arg(stage.max_attempts);
    if (stage.remind_after_days > 0)
        parts << CourseWords::tr("to be refreshed after %n day(s)", nullptr,
                                 stage.remind_after_days);
    return parts.join(" · ");
}

QString exam_words(const curriculum::ExamRule& exam) {
    QStringList parts;
    parts << CourseWords::tr("No help, no planned line, no read-outs but the time")
          << (exam.seeds.size() == 1
                  ? CourseWords::tr("one fixed case")
                  : CourseWords::tr("%n fixed case(s), one after the other, then from the first",
                                    nullptr, static_cast<int>(exam.seeds.size())));
    parts << CourseWords::tr("leaving uses up an attempt");
    if (exam.proctor) parts << CourseWords::tr("a proctor confirms that the exam may begin");
    if (exam.haptic_certificate)
        parts << CourseWords::tr("only on a haptic device, whose loop must stay sound");
    return parts.join("; ") + ".";
}

QString problem_words(const curriculum::CourseProblem& problem) {
    using curriculum::CourseFault;
    const QString value = qstr(problem.value);
    switch (problem.fault) {
        case CourseFault::kId:
        case CourseFault::kStageId:
            return CourseWords::tr("\"%1\" is no id: use letters, digits, _ . and - only.")
                .arg(value);
        case CourseFault::kTitle:
            return CourseWords::tr("The English title is missing.");
        case CourseFault::kNoStages:
            return CourseWords::tr("A course has 1 to 100 stages. Add one.");
        case CourseFault::kTask:
            return CourseWords::tr("There is no task \"%1\". Choose one of the list.").arg(value);
        case CourseFault::kStageIdTwice:
            return CourseWords::tr("\"%1\" is the id of another stage already.").arg(value);
        case CourseFault::kRequires:
            return CourseWords::tr("\"%1\" is not an earlier stage.").arg(value);
        case CourseFault::kBenchmark:
            return CourseWords::tr("A benchmark is 0 to 100 points.");
        case CourseFault::kConsecutive:
            return CourseWords::tr("In a row: 1 to 20 times.");
        case CourseFault::kPracticeLimit:
            return CourseWords::tr(
                       "Only an exam has a limit of attempts, not %1 at practice. Choose 0: no "
                       "limit.")
                .arg(value);
        case CourseFault::kTooFewAttempts:
            return CourseWords::tr(
                "%n attempt(s) are fewer than what is wanted in a row: it could never be "
                "mastered.",
                nullptr, value.toInt());
        case CourseFault::kRemind:
            return CourseWords::tr("0 to 3650 days.");
        case CourseFault::kNoSeeds:
            return CourseWords::tr("An exam needs its list of cases: 1 to 100 whole numbers.");
        case CourseFault::kSeedTwice:
            return CourseWords::tr("%1 stands twice in the list.").arg(value);
    }
    return {};
}

}  // namespace placode::ui

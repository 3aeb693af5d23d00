// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "curriculum/next_step.h"

#include <gmock/gmock.h>

namespace placode::curriculum {
namespace THIS_TEST {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::map<std::string, LocalText> kTitles{{"ring", {"Ring", "Okrąg"}},
                                               {"lift", {"Lift", "Unoszenie"}}};

/// Practise "ring" twice at 70 (again after 30 days), then an exam in "lift", two attempts.
Course course() {
    Course made;
    made.id = "c";
    made.stages.resize(2);
    made.stages[0].id = made.stages[0].task_id = "ring";
    made.stages[0].remind_after_days = 30;
    made.stages[1].id = "final";
    made.stages[1].task_id = "lift";
    made.stages[1].mode = StageMode::kExam;
    made.stages[1].requires_stages = {"ring"};
    made.stages[1].consecutive = 1;
    made.stages[1].max_attempts = 2;
    made.stages[1].exam.seeds = {11, 12};
    return made;
}

AttemptOutcome ring(double points, bool critical = false, const char* day = "2026-01-01") {
    AttemptOutcome outcome;
    outcome.task_id = "ring";
    outcome.points = points;
    outcome.critical = critical;
    outcome.at_utc = day;
    return outcome;
}

AttemptOutcome exam(double points, uint64_t seed) {
    AttemptOutcome outcome = ring(points);
    outcome.task_id = "lift";
    outcome.exam_course = "c";
    outcome.exam_stage = "final";
    outcome.seed = seed;
    outcome.proctor = "P";
    return outcome;
}

NextStep next(const std::vector<AttemptOutcome>& outcomes, const std::string& now = "2026-01-02",
              const CourseDates& dates = {}) {
    const Course made = course();
    return next_step(made, course_progress(made, outcomes, now), kTitles, dates, now);
}

TEST(NextStep, SaysWhatIsNextAndWhyInEveryState) {
    struct Case {
        std::vector<AttemptOutcome> outcomes;
        const char *now, *kind, *stage;
        int to_go;
        const char *en, *pl;
    };
    const Case cases[]{
        {{},
         "2026-01-02",
         "start",
         "ring",
         2,
         "at least 70 points, 2 times in a row",
         "co najmniej 70 pkt, 2 razy z rzędu"},
        {{ring(50)}, "2026-01-02", "continue", "ring", 2, "50 of the 70", "50 z potrzebnych 70"},
        {{ring(80)}, "2026-01-02", "continue", "ring", 1, "1 more attempt at 70", "1 próba na 70"},
        {{ring(80), ring(90, true)},
         "2026-01-02",
         "continue",
         "ring",
         2,
         "critical error",
         "błąd krytyczny"},
        {{ring(80), ring(80)}, "2026-01-02", "exam", "final", 1, "case 11", "przypadek 11"},
        {{ring(80), ring(80), exam(10, 11)},
         "2026-01-02",
         "exam",
         "final",
         1,
         "attempt 2: \"Lift\"",
         "Pozostało: 1 próba."},
        {{ring(80), ring(80), exam(10, 11), exam(10, 12)},
         "2026-01-02",
         "exhausted",
         "",
         0,
         "All 2 attempts at \"Lift\"",
         "wszystkie próby (2)"},
        {{ring(80), ring(80), exam(90, 11)},
         "2026-01-02",
         "finished",
         "",
         0,
         "due on 2026-01-31",
         "2026-01-31"},
        {{ring(80), ring(80), exam(90, 11)},
         "2026-02-01",
         "refresh",
         "ring",
         1,
         "from 2026-01-31 the skill fades",
         "umiejętność słabnie"},
        {{ring(80), ring(80), exam(90, 11), ring(75, false, "2026-02-01")},
         "2026-02-02",
         "finished",
         "",
         0,
         "2026-03-03",
         "2026-03-03"},
    };
    for (const Case& each : cases) {
        const NextStep step = next(each.outcomes, each.now);
        EXPECT_STREQ(next_kind_name(step.kind), each.kind) << step.reason.en;
        EXPECT_EQ(step.stage_id, each.stage);
        EXPECT_EQ(step.to_go, each.to_go) << step.reason.en;
        EXPECT_THAT(step.reason.en, HasSubstr(each.en));
        EXPECT_THAT(step.reason.pl, HasSubstr(each.pl));
        EXPECT_EQ(step.stage >= 0, !step.task_id.empty());
    }
}

/// Only an exam refreshes an exam, so its limit must not close it.
TEST(NextStep, APassedExamIsRefreshedThoughItsAttemptsAreUsed) {
    Course made = course();
    made.stages[0].remind_after_days = 0;
    made.stages[1].max_attempts = 1;
    made.stages[1].remind_after_days = 30;
    std::vector<AttemptOutcome> done{ring(80), ring(80), exam(90, 11)};
    const auto standing = [&](const std::string& now) { return course_progress(made, done, now); };
    const auto step = [&](const std::string& now) {
        return next_step(made, standing(now), kTitles, {}, now);
    };
    EXPECT_EQ(step("2026-01-30").kind, NextKind::kFinished);
    EXPECT_EQ(step("2026-02-01").kind, NextKind::kRefresh);
    EXPECT_EQ(step("2026-02-01").stage_id, "final");
    EXPECT_EQ(step("2026-02-01").seed, 12u);
    EXPECT_EQ(step("2026-02-01").attempts_left, -1);
    EXPECT_THAT(step("2026-02-01").reason.en, HasSubstr("A proctor has to be present."));
    // One that goes badly uses up nothing, and the next case is due.
    done.push_back(exam(10, 12));
    done.back().at_utc = "2026-02-01";
    EXPECT_EQ(standing("2026-02-02").stages[1].status, StageStatus::kMastered);
    EXPECT_EQ(standing("2026-02-02").stages[1].attempts, 2);
    EXPECT_EQ(standing("2026-02-02").stages[1].limited, 1);
    EXPECT_EQ(step("2026-02-02").kind, NextKind::kRefresh);
    EXPECT_EQ(step("2026-02-02").seed, 11u);
    done.push_back(exam(90, 11));
    done.back().at_utc = "2026-02-02";
    EXPECT_EQ(step("2026-02-02").kind, NextKind::kFinished);
}

TEST(NextStep, DatesOfTheAssignmentAreSaid) {
    const CourseDates dates{"2026-01-10", "2026-01-20"};
    const NextStep before = next({}, "2026-01-09T23:00:00Z", dates);
    EXPECT_EQ(before.kind, NextKind::kWait);
    EXPECT_THAT(before.reason.en, HasSubstr("begins on 2026-01-10"));
    EXPECT_EQ(before.stage, -1);
    const NextStep within = next({}, "2026-01-10", dates);
    EXPECT_EQ(within.kind, NextKind::kStart);
    EXPECT_EQ(within.days_left, 10);
    EXPECT_FALSE(within.overdue);
    EXPECT_FALSE(next({}, "2026-01-20T23:59:59Z", dates).overdue) << "the last day is a whole day";
    const NextStep late = next({}, "2026-01-21", dates);
    EXPECT_TRUE(late.overdue);
    EXPECT_EQ(late.days_left, -1);
    EXPECT_THAT(late.reason.en, HasSubstr("was due on 2026-01-20"));
    EXPECT_THAT(late.reason.pl, HasSubstr("minął"));
    const NextStep done = next({ring(80), ring(80), exam(90, 11)}, "2026-01-21", dates);
    EXPECT_FALSE(done.overdue) << "who has finished is not late";
}

TEST(NextStep, ATaskWithoutATitleIsNamedByItsId) {
    const Course made = course();
    const NextStep step = next_step(made, course_progress(made, {}), {}, {}, "2026-01-01");
    EXPECT_THAT(step.reason.en, HasSubstr("\"ring\""));
    EXPECT_THAT(step.reason.en, Not(HasSubstr("Ring")));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum

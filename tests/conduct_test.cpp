// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/conduct.h"

#include <gtest/gtest.h>

using namespace placode::curriculum;

namespace THIS_TEST {

TEST(Conduct, NamesOfModesGoThereAndBack) {
    for (const AttemptMode mode : {AttemptMode::kPractice, AttemptMode::kExam, AttemptMode::kStudy})
        EXPECT_EQ(mode_named(mode_name(mode)), mode);
    EXPECT_FALSE(mode_named("exams"));
    EXPECT_FALSE(mode_named(""));
}

TEST(Conduct, NamesOfAidsGoThereAndBack) {
    for (int bits = 0; bits < 16; ++bits) {
        const Aids aids{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
        EXPECT_EQ(aids_named(aid_names(aids)), aids);
    }
    EXPECT_EQ(aid_names({true, false, true, false}), "planned_line,warnings");
    EXPECT_FALSE(aids_named("planned_line,shadow"));
    EXPECT_FALSE(aids_named("planned_line, warnings"));  // no blanks
}

// What may falsify a measurement exists in practice only.
TEST(Conduct, NothingChangesTissueOrGivesAwayAScoreOutsidePractice) {
    for (const AttemptMode mode : {AttemptMode::kExam, AttemptMode::kStudy}) {
        const Conduct& conduct = conduct_of(mode);
        EXPECT_FALSE(conduct.tuning);
        EXPECT_FALSE(conduct.performance);
        EXPECT_FALSE(conduct.screenshots);
        EXPECT_FALSE(conduct.repeats);
        EXPECT_TRUE(conduct.always_ask);
    }
    EXPECT_EQ(conduct_of(AttemptMode::kExam).aids, Aids{});
    EXPECT_FALSE(conduct_of(AttemptMode::kExam).help);  // it stops the clock
    EXPECT_FALSE(conduct_of(AttemptMode::kStudy).own_device);
    EXPECT_FALSE(conduct_of(AttemptMode::kStudy).own_score);
    EXPECT_FALSE(conduct_of(AttemptMode::kStudy).own_account);
}

}  // namespace THIS_TEST

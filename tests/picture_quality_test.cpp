// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/picture_quality.h"

#include <gtest/gtest.h>

namespace placode::view {
namespace THIS_TEST {

// Pixels that are computed, relative: what the picture costs, roughly.
double pixels(const Quality& q) {
    return q.render_scale * q.render_scale * (1 + q.samples) * (q.shadows ? 1.2 : 1);
}

TEST(PictureQuality, EveryStepDownIsCheaperAndTheLastIsPlain) {
    Quality q{1.25, 4, false, true};
    int steps = 0;
    for (Quality before = q; make_simpler(q); before = q, ++steps) {
        EXPECT_LT(pixels(q) + (q.plain ? 0 : 1), pixels(before) + (before.plain ? 0 : 1));
        EXPECT_FALSE(before.plain && !q.plain);
        ASSERT_LT(steps, 20);
    }
    EXPECT_TRUE(q.plain);
    EXPECT_DOUBLE_EQ(q.render_scale, 0.3);
    EXPECT_EQ(q.samples, 0);
    EXPECT_FALSE(q.shadows);
}

TEST(PictureQuality, TheWayUpPassesTheSameStepsBackwards) {
    Quality q{1.25, 4, false, true};
    std::vector<Quality> down{q};
    while (make_simpler(q)) down.push_back(q);
    for (size_t i = down.size() - 1; i-- > 0;) {
        ASSERT_TRUE(make_richer(q));
        EXPECT_DOUBLE_EQ(q.render_scale, down[i].render_scale) << i;
        EXPECT_EQ(q.samples, down[i].samples) << i;
        EXPECT_EQ(q.plain, down[i].plain) << i;
        EXPECT_EQ(q.shadows, down[i].shadows) << i;
    }
    EXPECT_FALSE(make_richer(q));
}

TEST(PictureQuality, ASoftwareRendererStartsLowButNeverAboveWhatIsWanted) {
    EXPECT_DOUBLE_EQ(software_quality({1, 4, false}, 700).render_scale, 0.8);
    EXPECT_DOUBLE_EQ(software_quality({1, 4, false}, 1080).render_scale, 0.6);
    EXPECT_DOUBLE_EQ(software_quality({0.3, 0, true}, 1080).render_scale, 0.3);
    EXPECT_EQ(software_quality({1, 4, false, true}, 700).samples, 0);
    EXPECT_FALSE(software_quality({1, 4, false, true}, 700).shadows);
}

TEST(PictureQuality, NoMoreIsGivenBackThanItBeganWith) {
    const Quality first{0.8, 0, false};
    Quality q{0.3, 0, true};
    int steps = 0;
    for (Quality next = q; make_richer(next) && no_richer_than(next, first); q = next, ++steps)
        ASSERT_LT(steps, 20);
    EXPECT_EQ(q.render_scale, 0.8);
    EXPECT_FALSE(q.plain);
    EXPECT_EQ(q.samples, 0);
    EXPECT_FALSE(no_richer_than({0.8, 0, false, true}, first));
}

}  // namespace THIS_TEST
}  // namespace placode::view

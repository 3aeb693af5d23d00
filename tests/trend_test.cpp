// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/trend.h"

#include <gtest/gtest.h>

#include <vector>

using namespace placode::assessment;

TEST(Trend, SortsPeopleByTheirLastRuns) {
    struct Case {
        std::vector<double> points;
        const char* kind;
        double recent, best, gain;
    };
    const Case cases[]{
        {{}, "too few", 0, 0, 0},
        {{90, 90}, "too few", 90, 90, 0},
        {{10, 20, 30}, "too few", 20, 20, 0},
        {{70, 70, 70}, "at benchmark", 70, 70, 0},
        {{10, 20, 30, 40, 50, 60}, "improving", 50, 50, 30},
        {{40, 40, 40, 42, 42, 42}, "stuck", 42, 42, 2},
        {{40, 40, 40, 43, 43, 43}, "improving", 43, 43, 3},
        {{60, 60, 60, 50, 50, 50}, "regressed", 50, 60, -10},
        {{60, 60, 60, 51, 51, 51}, "stuck", 51, 60, -9},
        {{95, 95, 95, 80, 80, 80}, "regressed", 80, 95, -15},
    };
    for (const Case& each : cases) {
        const Trend found = trend(each.points, 70);
        EXPECT_STREQ(trend_name(found.kind), each.kind) << each.points.size();
        EXPECT_DOUBLE_EQ(found.recent, each.recent);
        EXPECT_DOUBLE_EQ(found.best, each.best);
        EXPECT_DOUBLE_EQ(found.gain, each.gain);
    }
}

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/vessel_tree.h"

#include <gtest/gtest.h>

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

TEST(VesselTree, GrowsInsideItsBordersAndThinsOutwards) {
    VesselSpec spec;
    spec.roots = {Vec2(0, 0)};
    spec.inside = [](const Vec2& p) { return p.norm() < 5; };
    spec.low = Vec2(-5, -5);
    spec.high = Vec2(5, 5);
    const std::vector<VesselSegment> tree = grow_vessels(spec);
    ASSERT_GT(tree.size(), 50U);
    for (const VesselSegment& s : tree) {
        EXPECT_LT(s.b.norm(), 5 + 2 * spec.step_mm);
        EXPECT_GE(s.radius_a, s.radius_b - 1e-12);
    }
    EXPECT_GT(tree.front().radius_a, 3 * tree.back().radius_b);
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The scripted hand with grasper and scissors over tissue that gives way. No tissue mechanics, so
// that only behaviour is tested.
#include "haptics/operators/resection_operator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace placode::haptics {
namespace THIS_TEST {

constexpr int kScissors = 0, kGrasper = 1, kPoints = 60;
constexpr double kFrameS = 1e-3;

/// Tissue at height 0 that is pushed in by a grasper's tip and rises again behind it.
struct SoftWorld {
    SoftWorld() {
        for (int i = 0; i < kPoints; ++i) {
            const double a = 2 * std::numbers::pi * i / kPoints;
            outline.emplace_back(0.002 * std::cos(a), 0.0015 * std::sin(a), 0);
        }
        normal.assign(kPoints, Vec3::UnitZ());
        cut.assign(kPoints, 0);
    }
    [[nodiscard]] Perception seen() const {
        Perception seen;
        seen.outline = outline;
        seen.outline_normal = normal;
        seen.outline_cut = cut;
        seen.grasp_place_m = Vec3(0, 0, std::min(0.0, tip_m.z()));
        seen.touches[kGrasper] = tip_m.z() < 1e-4;
        seen.holds[kGrasper] = closed && tip_m.z() < 1e-4;
        return seen;
    }
    void step(const HandAction& grasper) {
        tip_m = grasper.tip_m;
        closed = grasper.jaw_rad < 0.11;
    }
    std::vector<Vec3> outline, normal;
    std::vector<uint8_t> cut;
    Vec3 tip_m = Vec3(0, 0, 0.014);
    bool closed = false;
};

TEST(ResectionOperator, DoesNotPressAfterTissueThatGivesWay) {
    std::array<sim::ToolSpec, 2> specs{};
    specs[kScissors].kind = sim::ToolKind::kScissors;
    specs[kScissors].pivot_m = Vec3(-0.02, -0.055, 0.06);
    specs[kGrasper].kind = sim::ToolKind::kGrasper;
    specs[kGrasper].pivot_m = Vec3(-0.02, 0.055, 0.06);
    const std::array<Vec3, 2> homes{Vec3(-0.003, -0.007, 0.014), Vec3(-0.003, 0.007, 0.014)};
    ResectionTools tools;
    tools.scissors = kScissors;
    tools.grasper = kGrasper;
    ResectionOperator hands_at_work(OperatorLevel::kExpert, 1, tools, specs, homes);
    SoftWorld world;
    std::array<HandAction, 2> hands{};
    bool held = false;
    double deepest_m = 0;
    for (double time = 0; time < 10 && !held; time += kFrameS) {
        Perception seen = world.seen();
        seen.time_s = time;
        held = seen.holds[kGrasper];
        hands_at_work.see(seen);
        ASSERT_FALSE(hands_at_work.act(kFrameS, hands));
        world.step(hands[kGrasper]);
        deepest_m = std::min(deepest_m, hands[kGrasper].tip_m.z());
    }
    EXPECT_TRUE(held);
    // 0.2 mm of pressing, and tremor. A hand that follows what it presses was 7 mm deep here.
    EXPECT_GT(deepest_m, -5e-4);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics

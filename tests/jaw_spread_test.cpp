// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Jaws that open push tissue to both sides, no harder than a hand does.
#include "sim/contact/jaw_spread.h"

#include <gtest/gtest.h>

#include "sim/cutting/cutting.h"
#include "sim/step/step.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kSlotM = 0.002, kDeepM = 0.004;

/// A block with a slot from above, and a grasper that stands in it; jaws open across the slot.
class Slot {
 public:
    Slot(double youngs_modulus_pa, double jaw_force_n, bool spreads, int threads = 1)
        : scene_(make(youngs_modulus_pa, jaw_force_n, spreads)), state_(scene_, threads) {
        for (int32_t t = 0; t < scene_.body.tet_count(); ++t) {
            Vec3 middle = Vec3::Zero();
            for (const int32_t v : scene_.body.mesh().tets[static_cast<size_t>(t)])
                middle += 0.25 * scene_.body.mesh().rest[static_cast<size_t>(v)];
            if (std::abs(middle.y()) < kSlotM / 2 && middle.z() > -kDeepM)
                take_out(scene_, state_, t);
        }
    }
    /// Holds still with the jaws at an angle for some frames.
    void hold(double jaw_rad, int frames) {
        ToolInput input;
        input.set_pose({Vec3(0, 0, -0.003), Quat(0, 1, 0, 0)});  // the shaft comes from above
        input.jaw_rad = static_cast<float>(jaw_rad);
        input.engaged = 1;
        std::array<ToolFeedback, 1> feedback;
        for (int i = 0; i < frames; ++i) (void)step(scene_, state_, {&input, 1}, feedback);
    }
    /// Way of a wall away from the slot's middle [m], the larger of what it does anywhere.
    [[nodiscard]] double path(double side) const {
        double most = 0;
        for (size_t v = 0; v < scene_.body.mesh().rest.size(); ++v) {
            const Vec3& rest = scene_.body.mesh().rest[v];
            if (rest.y() * side > 0)
                most = std::max(most, side * (to_vec(state_.body.x[v]).y() - rest.y()));
        }
        return most;
    }
    [[nodiscard]] const State& state() const { return state_; }

 private:
    static Scene make(double youngs_modulus_pa, double jaw_force_n, bool spreads) {
        test::BoxOptions options;
        options.size_m = Vec3(0.006, 0.012, 0.006);
        options.cells = {6, 24, 6};
        options.material.youngs_modulus_pa = youngs_modulus_pa;
        options.material.poissons_ratio = 0.4;
        options.material.fail_stretch = options.material.injury_stretch = 5;
        options.heat = false;
        options.tool.kind = ToolKind::kGrasper;
        options.tool.shaft_radius_m = 0.0008;
        options.tool.tip_radius_m = 0.0004;
        options.tool.tip_length_m = 0.010;
        options.tool.jaw_open_rad = 0.8;
        options.tool.jaw_force_n = jaw_force_n;
        options.tool.jaws_spread = spreads;
        return test::box_scene(options);
    }
    Scene scene_;
    State state_;
};

TEST(JawSpread, OpeningJawsPushBothWallsAlikeAndTheHandFeelsNothing) {
    Slot slot(5000, 5, true);
    slot.hold(0, 50);
    EXPECT_LT(slot.path(1), 1e-5);
    slot.hold(0.36, 400);
    // Tips 9.6 mm from the hinge, 0.4 mm thick, in a slot of 2 mm.
    const double path = 0.0096 * std::sin(0.18) + 0.0004 - kSlotM / 2;
    EXPECT_NEAR(slot.path(1), path, 0.25 * path);
    EXPECT_NEAR(slot.path(-1), slot.path(1), 0.1 * path);
    EXPECT_GT(slot.state().undermining.jaws[0].push_n, 0.005F);
    EXPECT_LT(slot.state().tools[0].force_n.norm(),
              0.3 * static_cast<double>(slot.state().undermining.jaws[0].push_n));
}

TEST(JawSpread, StopWhereTissueIsStrongerThanTheHand) {
    Slot slot(60000, 0.05, true);
    slot.hold(0, 20);
    slot.hold(0.6, 600);
    EXPECT_LT(slot.state().undermining.jaws[0].rad, 0.5F);
    EXPECT_EQ(slot.state().tools[0].jaw_rad, slot.state().undermining.jaws[0].rad) << "as seen";
    EXPECT_LT(slot.state().undermining.jaws[0].push_n, 0.15F);
}

TEST(JawSpread, OtherJawsTouchAsIfTheyWereShut) {
    Slot slot(5000, 5, false);
    slot.hold(0, 20);
    slot.hold(0.6, 200);
    EXPECT_LT(slot.path(1), 1e-5);
    EXPECT_TRUE(slot.state().undermining.jaws.empty());
}

TEST(JawSpread, SameBitsOnAnyNumberOfThreads) {
    uint64_t hash = 0;
    for (const int threads : {1, 2, 3}) {
        Slot slot(5000, 1, true, threads);
        slot.hold(0.36, 120);
        if (threads > 1) {
            EXPECT_EQ(state_hash(slot.state()), hash) << threads;
        }
        hash = state_hash(slot.state());
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim

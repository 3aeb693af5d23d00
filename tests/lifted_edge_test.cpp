// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands undermine skin: one lifts the wound's edge in its jaws, the other goes in below it. No
// tissue is held by the program.
#include <gtest/gtest.h>

#include "sim/cutting/plane_parting.h"
#include "sim/step/step.h"
#include "tests/undermine_pad.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr size_t kRight = 0, kLeft = 1;
constexpr double kMm = 1e-3;

/// Planning values: fascia twice as stiff as muscle, skin that tears at a stretch of 2, a plane
/// that parts at 5 kPa, ports 19 degrees above the skin.
const Scene& pad() {
    static const auto scene = [] {
        OperativeFieldSpec spec = test::undermine_pad();
        spec.domain_y_m = 0.034;
        spec.plane->strength_pa = 5000;
        Material& skin = spec.materials[static_cast<size_t>(Tissue::kSkin)];
        skin.fail_stretch = 2;
        skin.injury_stretch = 1.8;
        Material& fascia = spec.materials[static_cast<size_t>(Tissue::kMuscle)];
        fascia.youngs_modulus_pa = 30e3;
        fascia.fail_stretch = 2;
        fascia.injury_stretch = 1.8;
        for (ToolSpec& tool : spec.tools) {
            tool.pivot_m.z() = 0.029;
            tool.jaw_touch_m = 0.0022;
        }
        return build_operative_field(spec);
    }();
    return *scene;
}

/// Where a tip is [mm], whether its jaws open upwards or along the wound, and how far.
struct Reach {
    Vec3 tip_mm = Vec3::Zero();
    bool upright = false;
    double jaw_rad = 0.02;
};

Pose pose_of(const ToolSpec& tool, const Reach& reach) {
    Mat3 turn;
    turn.col(2) = (kMm * reach.tip_mm - tool.pivot_m).normalized();
    const Vec3 along = Vec3::UnitZ().cross(turn.col(2)).normalized();
    turn.col(1) = reach.upright ? Vec3(turn.col(2).cross(along)) : along;
    turn.col(0) = turn.col(1).cross(turn.col(2));
    return {kMm * reach.tip_mm, Quat(turn)};
}

class TwoHands {
 public:
    explicit TwoHands(int threads = 1) : state_(pad(), threads) {
        now_[kRight].tip_mm = Vec3(10.5, -8, 6);
        now_[kLeft].tip_mm = Vec3(10.5, 3, 6);
        now_[kLeft].jaw_rad = 0.35;
    }
    /// Moves one hand evenly, the other stays.
    void go(size_t hand, const Reach& to, double seconds) {
        const Reach from = now_[hand];
        const int frames = static_cast<int>(std::lround(1000 * seconds));
        for (int f = 1; f <= frames; ++f) {
            const double share = static_cast<double>(f) / frames;
            now_[hand] = to;
            now_[hand].tip_mm = from.tip_mm + share * (to.tip_mm - from.tip_mm);
            now_[hand].jaw_rad = from.jaw_rad + share * (to.jaw_rad - from.jaw_rad);
            frame();
        }
    }
    /// The left hand takes the left edge and lifts it.
    void lift(double up_mm) {
        const Vec3 edge(10.5, 2.6, -0.5);
        go(kLeft, {edge, false, 0.35}, 0.6);
        go(kLeft, {edge, false, 0.12}, 0.3);
        go(kLeft, {Vec3(10.5, 2.6, up_mm), false, 0.12}, 0.8);
    }
    /// The right hand goes in below the edge, shut, and raises its tip twice.
    void raise_below(double x_mm) {
        go(kRight, {Vec3(x_mm, -1, 2), true}, 0.3);
        go(kRight, {Vec3(x_mm, 0.5, -0.9), true}, 0.3);
        for (const double y_mm : {4.0, 6.0}) {
            go(kRight, {Vec3(x_mm, y_mm, -0.8), true}, 0.3);
            go(kRight, {Vec3(x_mm, y_mm, 1.5), true}, 0.4);
            go(kRight, {Vec3(x_mm, y_mm - 0.5, -0.8), true}, 0.2);
        }
    }
    [[nodiscard]] double freed_mm2() const { return 1e6 * undermined_m2(pad(), state_, 1); }
    [[nodiscard]] int torn(Tissue tissue) const {
        int count = 0;
        for (size_t t = 0; t < state_.body.tet_alive.size(); ++t)
            count += state_.body.tet_alive[t] == 0 && pad().body.mesh().tissue[t] == tissue ? 1 : 0;
        return count;
    }
    [[nodiscard]] int torn() const {
        return torn(Tissue::kSkin) + torn(Tissue::kSubcutis) + torn(Tissue::kMuscle);
    }
    [[nodiscard]] const State& state() const { return state_; }

 private:
    void frame() {
        std::array<ToolInput, 2> inputs;
        std::array<ToolFeedback, 2> feedback;
        for (const size_t hand : {kRight, kLeft}) {
            inputs[hand].set_pose(pose_of(pad().tools[hand], now_[hand]));
            inputs[hand].jaw_rad = static_cast<float>(now_[hand].jaw_rad);
            inputs[hand].engaged = 1;
        }
        (void)step(pad(), state_, inputs, feedback);
    }

    State state_;
    std::array<Reach, 2> now_;
};

TEST(LiftedEdge, LiftedByASecondHandThePlaneOpensAndNothingTears) {
    TwoHands hands;
    hands.lift(2);
    EXPECT_GT(hands.state().grasps[kLeft].count, 0);
    EXPECT_GT(hands.freed_mm2(), 12);
    EXPECT_EQ(hands.torn(), 0);
    RecordProperty("freed_mm2", std::to_string(hands.freed_mm2()));
}

TEST(LiftedEdge, WhatGoesInBelowItFreesMoreAndTearsNoSkin) {
    TwoHands hands;
    hands.lift(2);
    const double lifted = hands.freed_mm2();
    for (const double x_mm : {9.0, 12.5}) hands.raise_below(x_mm);
    EXPECT_GT(hands.freed_mm2(), lifted + 12);
    EXPECT_EQ(hands.torn(Tissue::kSkin), 0);
    EXPECT_LT(hands.torn(), 10);
    RecordProperty("freed_mm2", std::to_string(hands.freed_mm2()));
    RecordProperty("torn", std::to_string(hands.torn()));
}

TEST(LiftedEdge, WithoutTheSecondHandTheSameWayFreesNothing) {
    TwoHands alone;
    alone.raise_below(9);
    EXPECT_LT(alone.freed_mm2(), 2);
    RecordProperty("freed_mm2", std::to_string(alone.freed_mm2()));
}

TEST(LiftedEdge, SameBitsOnAnyNumberOfThreads) {
    TwoHands one(1), three(3);
    one.lift(2);
    three.lift(2);
    EXPECT_EQ(state_hash(one.state()), state_hash(three.state()));
}

}  // namespace THIS_TEST
}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A needle pushed through the surface: it has no force, so that somebody has to say it. Pressing,
// touching and cutting are not that.

#include "curriculum/buried_watch.h"

#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "assessment/practice.h"
#include "curriculum/live_warnings.h"
#include "sim/step/snapshot.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::Vec3;

constexpr double kFrameS = 1e-3;

/// The tutorial's field, coarse, with hands moved by the test.
class Bench {
 public:
    explicit Bench(double hour = 4, double outward_m = 0.004)
        : task_(test::changed_task("familiarisation", {{"edge_ring_m", "0.0008"},
                                                       {"edge_placode_m", "0.0014"},
                                                       {"edge_outer_m", "0.003"}})),
          scene_(sim::build_operative_field(task_.scene)),
          state_(*scene_, 1),
          warnings_(*scene_) {
        sim::settle(*scene_, state_, 0.1);
        const sim::PracticeStep step{.hour = hour, .outward_m = outward_m};
        const sim::Vec2 at = assessment::practice_target(step, scene_->geometry, false);
        place_ = Vec3(at.x(), at.y(), surface_height(at));
        shaft_ = (place_ - scene_->tools[0].pivot_m).normalized();
        depth_m_ = -0.005;
        for (size_t i = 0; i < inputs_.size(); ++i) inputs_[i].engaged = i == 0 ? 1 : 0;
    }

    /// Along the shaft to `depth_m` below the surface at rest, at `speed_m_s`.
    void go(double depth_m, double speed_m_s, uint8_t pedals = 0) {
        const double step_m = std::copysign(speed_m_s * kFrameS, depth_m - depth_m_);
        while (std::abs(depth_m - depth_m_) > std::abs(step_m)) {
            depth_m_ += step_m;
            frame(pedals);
        }
        depth_m_ = depth_m;
    }
    void stay(double seconds, uint8_t pedals = 0) {
        for (int i = 0; i < static_cast<int>(seconds / kFrameS); ++i) frame(pedals);
    }
    /// What the watch writes at the end of the attempt.
    void end() {
        for (const sim::Event& e : warnings_.end(state_.time_s)) note(e);
    }
    [[nodiscard]] sim::Burial burial() const { return sim::burial_of(*scene_, state_, 0); }
    [[nodiscard]] const sim::State& state() const { return state_; }
    [[nodiscard]] const sim::Scene& scene() const { return *scene_; }
    [[nodiscard]] const Vec3& place() const { return place_; }

    std::vector<sim::Event> buried;
    double below_s = -1;   ///< Since then the tip was below the surface.
    double warned_s = -1;  ///< First time that it was said.

 private:
    [[nodiscard]] double surface_height(const sim::Vec2& at) const {
        double nearest = 1, height = 0;
        for (size_t v = 0; v < scene_->field.depth_m.size(); ++v) {
            if (scene_->field.depth_m[v] > 0) continue;
            const Vec3 x = to_vec(state_.body.x[v]);
            const double path = (x.head<2>() - at).norm();
            if (path >= nearest) continue;
            nearest = path;
            height = x.z();
        }
        return height;
    }
    void note(const sim::Event& event) {
        if (event.kind == sim::EventKind::kBuried) buried.push_back(event);
    }
    void frame(uint8_t pedals) {
        sim::Pose pose;
        pose.p = place_ + depth_m_ * shaft_;
        pose.q = sim::Quat::FromTwoVectors(Vec3::UnitZ(), shaft_);
        inputs_[0].set_pose(pose);
        inputs_[0].pedals = pedals;
        const size_t tools = scene_->tools.size();
        static_cast<void>(
            sim::step(*scene_, state_, {inputs_.data(), tools}, {feedback_.data(), tools}));
        const bool sampled = state_.frame % 10 == 0;
        warnings_.look(state_, {inputs_.data(), tools}, sampled);
        for (const sim::Event& e : warnings_.events()) note(e);
        if (below_s < 0 && burial().depth_m > 0) below_s = state_.time_s;
        const std::string_view said(warnings_.phrase().data());
        if (warned_s < 0 && said == "Stuck in tissue: draw back") warned_s = state_.time_s;
    }

    Task task_;
    std::shared_ptr<const sim::Scene> scene_;
    sim::State state_;
    LiveWarnings warnings_;
    std::array<sim::ToolInput, sim::kMaxTools> inputs_{};
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback_{};
    Vec3 place_, shaft_;
    double depth_m_ = 0;
};

TEST(BuriedWatch, ANeedlePushedFiveMillimetresBelowIsSaidWithinATenthAndNoted) {
    Bench bench;
    bench.go(0.005, 0.03);
    bench.stay(0.5);
    EXPECT_GT(bench.burial().depth_m, 0.002);
    sim::Snapshot seen;
    sim::fill_snapshot(bench.scene(), bench.state(), seen);
    EXPECT_NEAR(seen.tools[0].buried_m, bench.burial().depth_m, 1e-6);
    EXPECT_GE(seen.tools[0].buried_length_m, seen.tools[0].buried_m);
    ASSERT_GT(bench.below_s, 0);
    EXPECT_GT(bench.warned_s, 0);
    EXPECT_LT(bench.warned_s - bench.below_s, 0.3);
    EXPECT_TRUE(bench.buried.empty()) << "it is written when it ends";
    bench.go(-0.005, 0.03);
    ASSERT_EQ(bench.buried.size(), 1U);
    const sim::Event& event = bench.buried[0];
    EXPECT_EQ(event.tool, 0);
    EXPECT_GT(event.value, 0.5F);
    EXPECT_LT(event.value, 1.2F);
    EXPECT_GT(event.value2, 0.002F);
    EXPECT_LT(event.value2, 0.0065F);
    const Vec3 at(event.rest_position_m[0], event.rest_position_m[1], event.rest_position_m[2]);
    EXPECT_LT((at - bench.place()).norm(), 0.003);
    EXPECT_EQ(bench.burial().depth_m, 0);
}

TEST(BuriedWatch, TheEndOfTheAttemptWritesDownWhatIsStillBuried) {
    Bench bench;
    bench.go(0.004, 0.03);
    bench.stay(0.4);
    EXPECT_TRUE(bench.buried.empty());
    bench.end();
    ASSERT_EQ(bench.buried.size(), 1U);
    EXPECT_GT(bench.buried[0].value, 0.3F);
    EXPECT_EQ(bench.buried[0].time_s, bench.state().time_s);
}

TEST(BuriedWatch, PressingOnTheSurfaceIsNotBeingBelowIt) {
    Bench bench;
    bench.go(0.0008, 0.005);
    bench.stay(0.6);
    EXPECT_NE(bench.state().tools[0].in_contact, 0);
    bench.go(-0.003, 0.005);
    bench.end();
    EXPECT_LT(bench.below_s, 0);
    EXPECT_LT(bench.warned_s, 0);
    EXPECT_TRUE(bench.buried.empty());
}

TEST(BuriedWatch, ACutWithEnergyAndARestInItsKerfAreLegitimate) {
    Bench bench;
    bench.go(-0.0005, 0.02);
    bench.go(0.0012, 0.0015, sim::kPedalCut);
    bench.stay(0.5);
    bench.go(-0.003, 0.01);
    bench.end();
    EXPECT_LT(bench.warned_s, 0);
    EXPECT_TRUE(bench.buried.empty());
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum

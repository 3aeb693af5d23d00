// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Specs of jaws and strengths that cannot be; how a hand takes a needle.
#include "sim/suture/suture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/suture/needle_motion.h"
#include "tests/refused_field.h"

namespace placode::sim {
namespace THIS_TEST {

using placode::test::refused;

TEST(Suture, StrengthsAndJawsThatCannotBeAreRefused) {
    const auto with = [](auto&& change) {
        SutureSpec spec;
        change(spec);
        return refused([&] { return Suture(spec); });
    };
    EXPECT_EQ(with([](SutureSpec&) {}), "taken");
    EXPECT_EQ(with([](SutureSpec& s) { s.strength[0].puncture_n = 0; }),
              "strength.puncture_n|strength.puncture_n: found 0; expected a number from 0.001 to "
              "10");
    const auto field = [&](auto&& change) {
        const std::string text = with(change);
        return text.substr(0, text.find('|'));
    };
    EXPECT_EQ(field([](SutureSpec& s) { s.strength[3].cutting_share = 1.2; }),
              "strength.cutting_share");
    EXPECT_EQ(field([](SutureSpec& s) { s.strength[7].wall_friction_n_m = -1; }),
              "strength.wall_friction_n_m");
    EXPECT_EQ(field([](SutureSpec& s) { s.jaws.force_n = 0; }), "jaws.force_n");
    EXPECT_EQ(field([](SutureSpec& s) { s.jaws.friction = 3; }), "jaws.friction");
    EXPECT_EQ(field([](SutureSpec& s) { s.jaws.width_m = 0; }), "jaws.width_m");
    EXPECT_EQ(field([](SutureSpec& s) { s.jaws.pull_n_m = 1; }), "jaws.pull_n_m");
    EXPECT_EQ(field([](SutureSpec& s) { s.jaws.turn_n_m_rad = 0; }), "jaws.turn_n_m_rad");
    EXPECT_EQ(field([](SutureSpec& s) { s.point_friction = -1; }), "point_friction");
    EXPECT_EQ(field([](SutureSpec& s) { s.drag_per_s = -1; }), "drag_per_s");
    EXPECT_EQ(field([](SutureSpec& s) { s.strength[1].tear_n_m = 0; }), "strength.tear_n_m");
    EXPECT_EQ(field([](SutureSpec& s) { s.thread.length_m = 3; }), "thread.length_m");
    EXPECT_EQ(field([](SutureSpec& s) { s.thread.stretch_n = 0; }), "thread.stretch_n");
    EXPECT_EQ(field([](SutureSpec& s) { s.thread.friction.barb_n_m = -1; }), "thread.barb_n_m");
}

TEST(Suture, HandTakesTheNeedleWhereItIs) {
    SutureSpec spec;
    const Suture suture(spec);
    const Pose X_WN{Vec3(0.01, 0.02, 0.03), Quat(0.6, 0, 0.8, 0)};
    SutureState state(suture, X_WN);
    const uint64_t free = state_hash(state);
    take_needle(suture, state, {Vec3(0, 0, 0.05), Quat(0.8, 0.6, 0, 0)}, 1.0);
    EXPECT_EQ(state.hold.arc_m, suture.needle().arc_m()) << "no farther than the swage";
    const Pose target = state.hold.hand * state.hold.X_HN;
    EXPECT_LT((target.p - X_WN.p).norm(), 1e-15);
    EXPECT_LT(target.q.angularDistance(X_WN.q), 1e-7);
    EXPECT_NE(state_hash(state), free);
    let_go_needle(state);
    EXPECT_EQ(state.hold.held, 0);
}

TEST(Suture, ASlipOfManySubstepsLeavesRoomForTheBite) {
    SutureReport report;
    const auto told = [](SutureEventKind kind, double force_n) {
        SutureEvent event;
        event.kind = kind;
        event.force_n = force_n;
        return event;
    };
    for (int substep = 0; substep < 64; ++substep) {
        tell(report, told(SutureEventKind::kSlipped, 0.1 + 0.01 * (substep % 7)));
        tell(report, told(SutureEventKind::kTurned, 0.2));
    }
    tell(report, told(SutureEventKind::kEntered, 0.3));
    EXPECT_FALSE(report.dropped);
    ASSERT_EQ(report.event_count, 3);
    EXPECT_NEAR(report.events[0].force_n, 0.16, 1e-12) << "the hardest";
    EXPECT_EQ(report.events[2].kind, SutureEventKind::kEntered);
}

}  // namespace THIS_TEST
}  // namespace placode::sim

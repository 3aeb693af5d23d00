// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A needle in two pairs of jaws at once, in the open: what one hand pulls, the other feels; the
// weaker gives way; energy; the one that stays.
#include "sim/suture/needle_hold.h"

#include <gtest/gtest.h>

#include <string>

#include "suture_block.h"

namespace placode::sim {
namespace THIS_TEST {

using namespace test;

/// Over the block, the first jaws at 80 % of its arc and the second at a third of it.
class TwoHands {
 public:
    explicit TwoHands(double force_n = 10)
        : block_(options(force_n), SutureBlock::upright(Vec3(0, 0, 0.03))),
          first(block_.needle.needle),
          second(block_.needle.needle) {
        const double arc = needle_shape().arc_m();
        take_needle(block_.suture, block_.needle, first, 0.8 * arc);
        take_needle_too(block_.suture, block_.needle, second, 0.33 * arc);
    }
    /// One frame in which both hands go to where they are said to be.
    void frame(const Pose& one, const Pose& two) {
        block_.report.event_count = 0;
        block_.begin_frame();
        for (int s = 1; s <= SutureBlock::kSubsteps; ++s) {
            const double share = static_cast<double>(s) / SutureBlock::kSubsteps;
            const auto between = [&](const Pose& from, const Pose& to) {
                return Pose{from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
            };
            if (needle().second.hold.held != 0)
                move_second_hand(needle(), block_.scratch, between(second, two));
            block_.substep(between(first, one));
            for (int e = 0; e < block_.report.event_count; ++e)
                slipped[as_index(block_.report.events[as_index(e)].hold)] += 1;
        }
        first = one;
        second = two;
    }
    /// The second hand goes by `way`, then both rest.
    void draw_apart(const Vec3& way, int frames, int rest) {
        const Pose from = second;
        for (int i = 1; i <= frames; ++i)
            frame(first, {from.p + way * (static_cast<double>(i) / frames), from.q});
        for (int i = 0; i < rest; ++i) frame(first, second);
    }
    [[nodiscard]] SutureState& needle() { return block_.needle; }
    [[nodiscard]] const Needle& needle_shape() const { return block_.suture.needle(); }
    [[nodiscard]] const Suture& suture() const { return block_.suture; }
    [[nodiscard]] double stored() const { return hold_energy(block_.suture, block_.needle); }

 private:
    static BlockOptions options(double force_n) {
        BlockOptions options = skin_block();
        options.suture.jaws.force_n = force_n;
        return options;
    }
    SutureBlock block_;

 public:
    Pose first, second;
    std::array<int, 2> slipped{};
};

// Nothing else holds the needle: forces and torques of both hands cancel.
TEST(NeedleHold, WhatOneHandPullsTheOtherFeels) {
    TwoHands hands;
    hands.draw_apart(Vec3(1e-4, 2e-4, -1e-4), 50, 400);
    const NeedleHold &one = hands.needle().hold, &two = hands.needle().second.hold;
    EXPECT_GT(one.force_n.norm(), 0.02);
    EXPECT_LT((one.force_n + two.force_n).norm(), 1e-6 * one.force_n.norm() + 1e-9);
    const Pose& X_WN = hands.needle().needle;
    const Vec3 torque = (X_WN * one.held_N).cross(one.force_n) + one.torque_n_m +
                        (X_WN * two.held_N).cross(two.force_n) + two.torque_n_m;
    EXPECT_LT(torque.norm(), 1e-6 * one.torque_n_m.norm() + 1e-10);
    EXPECT_EQ(hands.slipped[0] + hands.slipped[1], 0);
}

// 10 N hold it, a fifth of that gives way: the jaws that open, and not the others.
TEST(NeedleHold, TheWeakerGivesWay) {
    for (const size_t weaker : {0U, 1U}) {
        TwoHands hands(2);
        hands.needle().second.firm[weaker] = 0.05;
        const double arcs[2] = {hands.needle().hold.arc_m, hands.needle().second.hold.arc_m};
        hands.draw_apart(Vec3(-1.0e-3, 0, 0.6e-3), 100, 50);
        SCOPED_TRACE(weaker);
        EXPECT_GT(hands.slipped[weaker], 0);
        EXPECT_EQ(hands.slipped[1 - weaker], 0);
        EXPECT_GT(hands.needle().work.jaws, 0);
        const double now[2] = {hands.needle().hold.arc_m, hands.needle().second.hold.arc_m};
        EXPECT_EQ(now[1 - weaker], arcs[1 - weaker]);
    }
}

// What the hands do is stored in both holds, or rubbed away in the jaws.
TEST(NeedleHold, EnergyIsAccountedFor) {
    for (const double force_n : {10.0, 0.2}) {
        SCOPED_TRACE(force_n);
        TwoHands hands(force_n);
        hands.draw_apart(Vec3(3e-4, 5e-4, -4e-4), 400, 200);
        const SutureWork& work = hands.needle().work;
        EXPECT_GT(work.hand, 1e-6);
        RecordProperty(force_n < 1 ? "slips_off" : "holds_off",
                       std::to_string(1 - (hands.stored() + work.jaws) / work.hand));
        EXPECT_NEAR(work.hand, hands.stored() + work.jaws, 0.03 * work.hand);
        EXPECT_EQ(work.jaws > 0, force_n < 1);
    }
}

TEST(NeedleHold, WhoStaysHoldsItAlone) {
    TwoHands hands;
    const double arc = hands.needle().second.hold.arc_m;
    let_go_needle(hands.needle());
    EXPECT_EQ(hands.needle().hold.held, 1);
    EXPECT_EQ(hands.needle().hold.arc_m, arc);
    EXPECT_EQ(hands.needle().second.hold.held, 0);
    TwoHands back;
    const double kept = back.needle().hold.arc_m;
    let_go_second(back.needle());
    EXPECT_EQ(back.needle().hold.arc_m, kept);
    EXPECT_EQ(back.needle().second.hold.held, 0);
    let_go_needle(back.needle());
    EXPECT_EQ(back.needle().hold.held, 0);
}

// A second hand that holds nothing changes no hash: recordings with one driver keep theirs.
TEST(NeedleHold, OnlyASecondHandThatHoldsIsHashed) {
    TwoHands hands;
    const uint64_t both = state_hash(hands.needle());
    let_go_second(hands.needle());
    const uint64_t alone = state_hash(hands.needle());
    EXPECT_NE(both, alone);
    hands.needle().second.hold.arc_m = 1e-3;
    hands.needle().second.firm = {0.5, 0.5};
    EXPECT_EQ(state_hash(hands.needle()), alone);
}

}  // namespace THIS_TEST
}  // namespace placode::sim

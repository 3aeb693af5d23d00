// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The hand that holds a wound's edge, in a world of one edge: jaws that close at it hold it, and
// open jaws let it go. No tissue mechanics, so that only behaviour is tested.
#include "haptics/operators/edge_holder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace placode::haptics {
namespace THIS_TEST {

constexpr double kFrameS = 1e-3, kLongestS = 30, kRaiseM = 0.002;
constexpr double kNearM = 1e-3;      // jaws this close to the edge take it
constexpr double kClosedRad = 0.16;  // when they are closed so far
const Vec3 kHome{0.03, -0.02, 0.03}, kEdge{0.004, 0.002, 0.001}, kAlong = Vec3::UnitY();

OperatorProfile steady() {
    OperatorProfile profile;
    profile.tremor_m = 0;
    return profile;
}

struct HeldEdge {
    EdgeHolder holder{steady(), 1, kHome};
    Vec3 edge_m = kEdge;
    double loose_rad = 0.2;  ///< Jaws open so far let it go.
    bool holds = false, slips = false;
    HandAction hand;
    double time_s = 0;

    void want(const Vec3& place_m) { holder.want(true, place_m, kAlong, kRaiseM); }
    void want_nothing() { holder.want(false, Vec3::Zero(), Vec3::UnitX(), 0); }

    void frame() {
        holder.see(holds);
        hand = holder.act(time_s, kFrameS);
        time_s += kFrameS;
        if (hand.jaw_rad >= loose_rad) holds = false;
        if (!slips && hand.jaw_rad <= kClosedRad && (hand.tip_m - edge_m).norm() < kNearM)
            holds = true;
    }
    /// Until the hand has done what was wanted; `look` sees every frame. False: it never has.
    [[nodiscard]] bool goes_on(const std::function<void()>& look = {}) {
        for (const double end_s = time_s + kLongestS; time_s < end_s;) {
            frame();
            if (look) look();
            if (holder.ready()) return true;
        }
        return false;
    }
    void rests(double seconds) {
        for (const double end_s = time_s + seconds; time_s < end_s;) frame();
    }
};

TEST(EdgeHolder, StaysAtHomeWhileNothingIsWanted) {
    HeldEdge edge;
    EXPECT_TRUE(edge.holder.ready());
    for (int i = 0; i < 500; ++i) {
        edge.frame();
        ASSERT_EQ(edge.hand.tip_m, kHome);
        ASSERT_TRUE(edge.hand.engaged);
        ASSERT_EQ(edge.hand.pedals, 0);
    }
    EXPECT_TRUE(edge.holder.ready());
}

TEST(EdgeHolder, TakesTheEdgeFromAboveAndRaisesIt) {
    HeldEdge edge;
    edge.want(kEdge);
    EXPECT_FALSE(edge.holder.ready());
    bool came_from_above = true, closed_elsewhere = false;
    double widest_rad = 0;
    ASSERT_TRUE(edge.goes_on([&] {
        const Vec3 from_edge = edge.hand.tip_m - kEdge;
        if (from_edge.z() < 0.0035 && from_edge.head<2>().norm() > 1e-6) came_from_above = false;
        widest_rad = std::max(widest_rad, edge.hand.jaw_rad);
        // They are open before the hand goes down.
        if (!edge.holds && from_edge.z() < 0.0035 && from_edge.z() > kNearM &&
            edge.hand.jaw_rad < widest_rad)
            closed_elsewhere = true;
        EXPECT_FALSE(edge.holder.ready() && !edge.holds);
    }));
    EXPECT_TRUE(came_from_above);
    EXPECT_FALSE(closed_elsewhere);
    EXPECT_GT(widest_rad, edge.loose_rad);
    EXPECT_TRUE(edge.holds);
    EXPECT_EQ(edge.hand.opening, kAlong) << "the jaws open along the wound";
    EXPECT_LE(edge.hand.jaw_rad, kClosedRad);
    EXPECT_NEAR((edge.hand.tip_m - (kEdge + kRaiseM * Vec3::UnitZ())).norm(), 0, 1e-9);
    edge.rests(2);
    EXPECT_TRUE(edge.holds && edge.holder.ready()) << "it goes on holding";
}

TEST(EdgeHolder, LowersTheEdgeBeforeItLetsGo) {
    HeldEdge edge;
    edge.want(kEdge);
    ASSERT_TRUE(edge.goes_on());
    const double held_rad = edge.hand.jaw_rad;
    edge.want_nothing();
    EXPECT_FALSE(edge.holder.ready());
    double highest_m = 0, widest_rad = 0;
    ASSERT_TRUE(edge.goes_on([&] {
        widest_rad = std::max(widest_rad, edge.hand.jaw_rad);
        if (edge.holds && edge.hand.jaw_rad > held_rad + 0.01)
            highest_m = std::max(highest_m, edge.hand.tip_m.z() - kEdge.z());
    }));
    EXPECT_GT(highest_m, 0) << "it opened while it held";
    EXPECT_LT(highest_m, 5e-4);
    EXPECT_FALSE(edge.holds);
    EXPECT_LT(widest_rad, 0.3) << "no wider than thin tissue needs";
    EXPECT_GT(edge.hand.tip_m.z() - kEdge.z(), 0.0035) << "it is away";
    edge.rests(3);
    EXPECT_NEAR((edge.hand.tip_m - kHome).norm(), 0, 1e-9);
    EXPECT_TRUE(edge.holder.ready());
}

TEST(EdgeHolder, OpensWiderWhereTheEdgeDoesNotComeFree) {
    HeldEdge edge;
    edge.loose_rad = 0.3;
    edge.want(kEdge);
    ASSERT_TRUE(edge.goes_on());
    edge.want_nothing();
    ASSERT_TRUE(edge.goes_on());
    EXPECT_FALSE(edge.holds);
    EXPECT_GE(edge.hand.jaw_rad, edge.loose_rad);
}

TEST(EdgeHolder, APlaceThatDiffersByLittleIsTheSame) {
    HeldEdge edge;
    edge.want(kEdge);
    ASSERT_TRUE(edge.goes_on());
    const Vec3 there = edge.hand.tip_m;
    edge.want(kEdge + Vec3(0, 0.002, 0));
    EXPECT_TRUE(edge.holder.ready());
    edge.rests(1);
    EXPECT_EQ(edge.hand.tip_m, there);
    // Another one: it lets go of this and takes that.
    const Vec3 other = kEdge + Vec3(0, 0.005, 0);
    edge.want(other);
    EXPECT_FALSE(edge.holder.ready());
    bool let_go = false;
    ASSERT_TRUE(edge.goes_on([&] {
        if (edge.holds || let_go) return;
        let_go = true;
        edge.edge_m = other;
    }));
    EXPECT_TRUE(let_go && edge.holds);
    EXPECT_NEAR((edge.hand.tip_m - (other + kRaiseM * Vec3::UnitZ())).norm(), 0, 1e-9);
}

TEST(EdgeHolder, GivesUpWhereItCannotHoldAndTriesAnotherPlace) {
    HeldEdge edge;
    edge.slips = true;
    edge.want(kEdge);
    int tries = 0;
    bool closed = false;
    const auto count = [&] {
        const bool now =
            edge.hand.jaw_rad <= kClosedRad && (edge.hand.tip_m - edge.edge_m).norm() < kNearM;
        if (now && !closed) ++tries;
        closed = now;
    };
    ASSERT_TRUE(edge.goes_on(count)) << "the other hand is not kept waiting";
    EXPECT_GE(tries, 2);
    const int given_up_after = tries;
    for (int i = 0; i < 5000; ++i) {
        edge.frame();
        count();
    }
    EXPECT_EQ(tries, given_up_after) << "it does not go on poking";
    EXPECT_TRUE(edge.holder.ready());
    EXPECT_NEAR((edge.hand.tip_m - kHome).norm(), 0, 1e-9);
    edge.edge_m = kEdge + Vec3(0, 0.005, 0);
    edge.slips = false;
    edge.want(edge.edge_m);
    EXPECT_FALSE(edge.holder.ready());
    ASSERT_TRUE(edge.goes_on());
    EXPECT_TRUE(edge.holds);
}

TEST(EdgeHolder, WhatIsNoLongerWantedOnTheWayIsLetGo) {
    HeldEdge edge;
    edge.want(kEdge);
    for (int i = 0; i < 300; ++i) edge.frame();
    ASSERT_NE(edge.hand.tip_m, kHome);
    edge.want_nothing();
    EXPECT_FALSE(edge.holder.ready());
    ASSERT_TRUE(edge.goes_on());
    EXPECT_FALSE(edge.holds);
    edge.rests(3);
    EXPECT_NEAR((edge.hand.tip_m - kHome).norm(), 0, 1e-9);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics

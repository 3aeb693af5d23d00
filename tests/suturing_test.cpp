// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A needle in an operative scene: a bite with a driver through step(), what the driver feels, jaws
// that take and let go, an instrument at the same place, memory and bits.
#include "sim/step/suturing.h"

#include <gtest/gtest.h>

#include "count_allocations.h"
#include "sim/ledger/ledger.h"
#include "sim/step/needle_jaws.h"
#include "sim/world/saved_state.h"
#include "sim/world/scratch.h"
#include "stitch_scene.h"

namespace placode::sim {
namespace THIS_TEST {

using test::leaning;
using test::second_spec;
using test::Stitch;
using test::StitchOptions;
using test::turned;

constexpr double kBiteM = 9e-3;  // of the needle's path: in, and well out again

void record(const char* name, double value) {
    ::testing::Test::RecordProperty(name, shortest_text(value));
}

/// -1 to 1.
class Dice {
 public:
    double operator()() {
        seed_ = seed_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed_ >> 33) / static_cast<double>(1ULL << 31) * 2 - 1;
    }
    Vec3 place() { return Vec3((*this)(), (*this)(), (*this)()); }

 private:
    uint64_t seed_ = 1;
};

TEST(Suturing, ABiteHasTwoPeaksThatTheDriverFeelsAndLeavesPassages) {
    Stitch stitch;
    double entry = 0, exit = 0, between = 1e9, at_entry = 0;
    bool in = false;
    stitch.drive(kBiteM, 5e-3, [&] {
        const auto point = static_cast<double>(stitch.state.suturing.point_n);
        const double felt = stitch.state.tools[0].force_n.norm();
        in = in || stitch.find(EventKind::kNeedleEntered) != nullptr;
        if (!in) {
            entry = std::max(entry, point);
            at_entry = std::max(at_entry, felt);
        } else if (stitch.find(EventKind::kNeedleLeft) == nullptr) {
            if (stitch.needle().point.mode == PointMode::kInside)
                between = std::min(between, point);
            exit = std::max(exit, point);
        }
    });
    record("entry_n", entry);
    record("exit_n", exit);
    record("felt_at_entry_n", at_entry);
    EXPECT_NEAR(entry, 0.06, 0.003);
    EXPECT_NEAR(exit, 0.06, 0.003);
    EXPECT_LT(between, 0.62 * 0.06);
    // In no channel yet: all of it is the point's.
    EXPECT_NEAR(at_entry, 0.06, 0.003);
    EXPECT_GT(stitch.needle().passage_count, 10);
    const Event* entered = stitch.find(EventKind::kNeedleEntered);
    const Event* left = stitch.find(EventKind::kNeedleLeft);
    ASSERT_NE(entered, nullptr);
    ASSERT_NE(left, nullptr);
    EXPECT_EQ(entered->tool, 0);
    EXPECT_EQ(entered->tissue, Tissue::kSkin);
    EXPECT_NEAR(entered->value, 0.06, 0.003);
    EXPECT_NEAR(left->value, 0.06, 0.003);
    EXPECT_LT(entered->time_s, left->time_s);
    // The circle meets the surface at +-sqrt(R^2 - (R - 1.4 mm)^2) = 3.10 mm, at a sine of 0.75.
    // The skin gives way by up to 0.8 mm before it opens, so that the needle has turned further
    // (0.61), and friction draws the tissue along.
    EXPECT_NEAR(entered->rest_position_m[0], 3.10e-3, 0.25e-3);
    EXPECT_NEAR(left->rest_position_m[0], -3.10e-3, 0.8e-3);
    EXPECT_NEAR(entered->rest_position_m[2], 0, 1e-6);
    EXPECT_LT(entered->value2, 0.75);
    EXPECT_GT(entered->value2, 0.61);
    EXPECT_NEAR(left->value2, 1.4e-3, 0.25e-3);
    EXPECT_EQ(entered->hash, 1U);
    EXPECT_GE(entered->element, 0);
    EXPECT_EQ(stitch.state.tools[0].in_contact, 0) << "the driver itself touches nothing";
}

// The driver keeps off it all the while: it is the needle that touches.
TEST(Suturing, ThePointOnThePlacodeIsAContactOfTheDriver) {
    for (const Tissue tissue : {Tissue::kSkin, Tissue::kPlacode}) {
        StitchOptions options;
        options.tissue = tissue;
        Stitch stitch(options);
        double felt = 0;
        // At a sine of 0.75 to the surface: 0.2 mm deep, from 0.05 mm above it.
        stitch.drive(0.35e-3, 5e-3, [&] {
            felt = std::max(felt, static_cast<double>(stitch.state.suturing.point_n));
        });
        stitch.rest(100);
        stitch.drive(-1e-3);
        stitch.rest(100);
        ASSERT_EQ(stitch.find(EventKind::kNeedleEntered), nullptr);
        ASSERT_GT(felt, stitch.scene.contact.placode_warn_force_n);
        EXPECT_EQ(stitch.state.tools[0].in_contact, 0);
        const Event* contact = stitch.find(EventKind::kPlacodeContact);
        ASSERT_EQ(contact != nullptr, tissue == Tissue::kPlacode);
        if (contact == nullptr) continue;
        EXPECT_EQ(contact->tool, 0);
        EXPECT_GT(contact->value, 0.1F) << "seconds";
        EXPECT_NEAR(contact->value2, felt, 0.1 * felt);
    }
}

// In and out again: the point has left the tissue, and the wire is drawn on through it.
TEST(Suturing, TheWireInThePlacodeIsAContactOfTheDriver) {
    for (const Tissue tissue : {Tissue::kSkin, Tissue::kPlacode}) {
        StitchOptions options;
        options.tissue = tissue;
        Stitch stitch(options);
        double wire_n = 0;
        int frames = 0;
        stitch.drive(kBiteM, 5e-3, [&] {
            if (stitch.find(EventKind::kNeedleLeft) == nullptr ||
                stitch.needle().point.mode != PointMode::kFree)
                return;
            ++frames;
            wire_n = std::max(wire_n, stitch.state.tools[0].placode_force_n);
        });
        ASSERT_GT(frames, 100);
        ASSERT_GT(stitch.needle().passage_count, 10);
        EXPECT_EQ(stitch.state.tools[0].in_contact, 0) << "the driver itself touches nothing";
        if (tissue == Tissue::kPlacode)
            EXPECT_GT(wire_n, stitch.scene.contact.placode_warn_force_n);
        else
            EXPECT_EQ(wire_n, 0);
    }
}

// What the hand pushes through driver and needle is what the bottom carries; the haptic device gets
// it as its spring to the driver's place.
TEST(Suturing, DriverBottomAndHandCarryTheSame) {
    Stitch stitch;
    stitch.drive(4e-3);
    stitch.rest(600);
    ASSERT_GT(stitch.needle().passage_count, 3);
    const Vec3 tool = stitch.state.tools[0].force_n, bottom = stitch.carried_n();
    record("tool_n", tool.norm());
    record("off_bottom_n", (tool + bottom).norm());
    EXPECT_GT(tool.norm(), 0.02);
    EXPECT_LT((tool + bottom).norm(), std::max(0.01 * tool.norm(), 2e-4));
    EXPECT_LT((stitch.feedback[0].force_n - tool).norm(), 1e-12);
    const Vec3 hand = stitch.inputs[0].pose().p;
    const Vec3 yields = stitch.state.tools[0].proxy.p - hand;
    EXPECT_LT((stitch.scene.tools[0].hand_n_m * yields - tool).norm(), 0.02 * tool.norm());
    EXPECT_GT(stitch.feedback[0].stiffness_n_m, 100);
}

// An instrument that presses where the needle is: both act on the same vertices, which are solved
// with both. Without that their sum would not reach the bottom.
TEST(Suturing, AProbeOnTheNeedlesPlaceAndTheNeedleBothReachTheBottom) {
    StitchOptions options;
    options.other = second_spec(ToolKind::kProbe);
    Stitch stitch(options);
    stitch.inputs[1] = leaning(Vec3(3.3e-3, 0, 2e-3));
    stitch.drive(5e-3);
    ASSERT_GT(stitch.needle().passage_count, 5);
    for (int i = 1; i <= 300; ++i) {
        stitch.inputs[1] = leaning(Vec3(3.3e-3, 0, 2e-3 - i * 8e-6));
        stitch.frame();
    }
    stitch.rest(600);
    EXPECT_GT(stitch.shared_vertices(), 0) << "nothing is shared: the test would see little";
    const Vec3 probe = stitch.state.tools[1].force_n, driver = stitch.state.tools[0].force_n;
    EXPECT_GT(probe.norm(), 0.02);
    EXPECT_GT(driver.norm(), 0.01);
    const Vec3 all = probe + driver + stitch.carried_n();
    record("probe_n", probe.norm());
    record("driver_n", driver.norm());
    record("off_n", all.norm());
    EXPECT_LT(all.norm(), 0.01 * (probe.norm() + driver.norm()));
    EXPECT_TRUE(stitch.finite());
}

// The same with jaws that hold vertices in place: they feel what the needle pulls at these.
TEST(Suturing, AGrasperFeelsTheNeedleThatPullsAtWhatItHolds) {
    StitchOptions options;
    options.other = second_spec(ToolKind::kGrasper);
    options.other->jaw_force_n = 5;  // nothing slips
    Stitch stitch(options);
    const auto grasper = [&](double z, double jaw) {
        stitch.inputs[1] = leaning(Vec3(2.8e-3, 0, z));
        stitch.inputs[1].jaw_rad = static_cast<float>(jaw);
    };
    grasper(2e-3, 0.6);
    stitch.drive(5e-3);
    for (int i = 0; i < 100; ++i) {
        grasper(1e-4 + (2e-3 - 1e-4) * (99 - i) / 100, 0.6);
        stitch.frame();
    }
    for (int i = 1; i <= 100; ++i) {
        grasper(1e-4, 0.6 - 0.59 * i / 100);
        stitch.frame();
    }
    const Grasp& held = stitch.state.grasps[1];
    ASSERT_GT(held.count, 3);
    stitch.drive(0.6e-3);
    stitch.rest(800);
    int shared = 0;
    for (int i = 0; i < held.count; ++i)
        for (int p = 0; p < stitch.needle().passage_count; ++p) {
            const auto& c = corners(stitch.scene.body, stitch.state.body,
                                    stitch.needle().passages[as_index(p)].at.tet);
            shared += std::count(c.begin(), c.end(), held.held[as_index(i)].vertex) > 0 ? 1 : 0;
        }
    EXPECT_GT(shared, 0) << "nothing is shared: the test would see little";
    const Vec3 grasp = stitch.state.tools[1].force_n, driver = stitch.state.tools[0].force_n;
    const Vec3 all = grasp + driver + stitch.carried_n();
    EXPECT_GT(driver.norm(), 0.02);
    record("grasp_n", grasp.norm());
    record("driver_n", driver.norm());
    record("off_n", all.norm());
    EXPECT_LT(all.norm(), 0.02 * (grasp.norm() + driver.norm()));
}

TEST(Suturing, JawsThatOpenInABiteLeaveTheNeedleThereAndTakeItAgain) {
    Stitch stitch;
    stitch.drive(4e-3);
    EXPECT_EQ(stitch.state.suturing.driver, 0);
    ASSERT_NE(stitch.find(EventKind::kNeedleTaken), nullptr);
    stitch.jaws(0.6);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
    EXPECT_EQ(stitch.needle().hold.held, 0);
    const Event* released = stitch.find(EventKind::kNeedleReleased);
    ASSERT_NE(released, nullptr);
    EXPECT_NEAR(released->value, 0.43, 0.02) << "seconds held";
    // 61 % of the puncture go on cutting, and the wall rubs with 40 N/m over some 3 mm.
    EXPECT_GT(released->value2, 0.06);
    EXPECT_LT(released->value2, 0.2);
    stitch.rest(300);  // springs back a little
    const Vec3 before = stitch.middle_m();
    stitch.rest(1000);
    EXPECT_LT((stitch.middle_m() - before).norm(), 50e-6);
    EXPECT_GT(stitch.needle().passage_count, 3);
    EXPECT_LT(stitch.state.tools[0].needle_n.norm(), 1e-12);
    // Closed beside the wire, they take nothing; closed on it, they do.
    Pose away = stitch.at(stitch.driven_m);
    away.p.z() += 3e-3;
    stitch.driver(away, stitch.jaw_rad);
    stitch.jaws(0);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
    stitch.driver(stitch.at(stitch.driven_m), 0);
    stitch.rest(50);
    EXPECT_EQ(stitch.state.suturing.driver, -1) << "shut jaws take nothing";
    stitch.jaws(0.6);
    stitch.jaws(0);
    ASSERT_EQ(stitch.state.suturing.driver, 0);
    EXPECT_NEAR(stitch.needle().hold.arc_m, test::kHeldShare * 13e-3, 0.6e-3);
    stitch.drive(kBiteM - 4e-3);
    EXPECT_NE(stitch.find(EventKind::kNeedleLeft), nullptr) << "and the bite goes on";
}

TEST(Suturing, ClosedJawsCentreTheWire) {
    Stitch stitch;
    stitch.rest(5);
    stitch.jaws(0.6);
    stitch.rest(1);
    Pose off = stitch.at(0);
    off.p += off.q * Vec3(0, 0.15e-3, 0);
    stitch.driver(off, stitch.jaw_rad);
    stitch.rest(20);
    stitch.jaws(0);
    ASSERT_EQ(stitch.state.suturing.driver, 0);
    stitch.rest(200);
    const Vec3 wire = stitch.state.tools[0].proxy.inverse() *
                      (stitch.needle().needle * stitch.needle().hold.held_N);
    EXPECT_NEAR(wire.y(), 0, 10e-6);
}

// With gravity: it sinks, comes to lie on the block and stays; a driver that finds it takes it.
TEST(Suturing, ANeedleDroppedInTheOpenLiesOnTheTissueAndCanBeTaken) {
    StitchOptions options;
    options.gravity = Vec3(0, 0, -9.81);
    Stitch stitch(options);
    Pose up = stitch.at(0);
    up.p.z() += 3e-3;
    stitch.driver(up);
    stitch.rest(20);
    for (int i = 1; i <= 50; ++i) {
        stitch.inputs[0].jaw_rad = static_cast<float>(0.6 * i / 50);
        stitch.frame();
    }
    up.p.z() += 20e-3;
    stitch.driver(up, 0.6);
    stitch.rest(2500);
    ASSERT_TRUE(stitch.finite());
    const Vec3 before = stitch.middle_m();
    stitch.rest(1000);
    EXPECT_LT((stitch.middle_m() - before).norm(), 50e-6) << "it lies still";
    const Needle& needle = stitch.scene.suture->needle();
    double lowest = 1, highest = -1;
    for (int i = 0; i <= 20; ++i) {
        const Vec3 p = stitch.needle().needle * needle.at(needle.arc_m() * i / 20).place_m;
        if (std::abs(p.x()) > 4.9e-3 || std::abs(p.y()) > 1.9e-3) continue;  // over the edge
        lowest = std::min(lowest, p.z());
        highest = std::max(highest, p.z());
    }
    // It is held at nine places along the wire: between them it may sag over an edge.
    EXPECT_GT(lowest, -0.2e-3) << "on the block, not in it";
    EXPECT_LT(highest, 3e-3);
    // A driver over the wire.
    const double arc = 0.5 * needle.arc_m();
    const Vec3 wire = stitch.needle().needle * needle.at(arc).place_m;
    const Vec3 along = stitch.needle().needle.q * needle.at(arc).back;
    Mat3 r;
    r.col(0) = Vec3(along - along.z() * Vec3::UnitZ()).normalized();
    r.col(2) = -Vec3::UnitZ();
    r.col(1) = r.col(2).cross(r.col(0));
    stitch.driver({wire - 0.4e-3 * Vec3::UnitZ(), Quat(r)}, 0.6);
    stitch.rest(100);
    stitch.jaw_rad = 0.6;
    stitch.jaws(0);
    EXPECT_EQ(stitch.state.suturing.driver, 0);
}

TEST(Suturing, ALyingNeedleIsThereFromTheStart) {
    StitchOptions options;
    options.lies = true;
    options.gravity = Vec3(0, 0, -9.81);
    Stitch stitch(options);
    Pose away = stitch.at(0);
    away.p.z() += 20e-3;
    stitch.driver(away, 0.6);
    stitch.rest(1500);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
    // Flat: the wire's axis one radius over the block.
    const double wire = stitch.scene.suture->needle().spec().wire_radius_m;
    EXPECT_NEAR(stitch.needle().needle.p.z(), wire, 0.05e-3);
    EXPECT_NEAR(std::abs((stitch.needle().needle.q * Vec3::UnitZ()).z()), 1, 1e-3);
}

// Window devices begin with open jaws: the needle must not fall before a hand has closed them.
TEST(Suturing, TheNeedleIsLockedInJawsThatHaveNotYetClosed) {
    Stitch stitch;
    stitch.driver(stitch.at(0), 0.6);
    stitch.jaw_rad = 0.6;
    stitch.rest(50);
    EXPECT_EQ(stitch.state.suturing.driver, 0);
    stitch.jaws(0);
    stitch.jaws(0.6);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
}

TEST(Suturing, ADriverWithoutAHandHoldsNothing) {
    Stitch stitch;
    stitch.inputs[0].engaged = 0;
    stitch.rest(5);
    EXPECT_EQ(stitch.state.suturing.placed, 0);
    stitch.inputs[0].engaged = 1;
    stitch.rest(5);
    EXPECT_EQ(stitch.state.suturing.driver, 0);
    stitch.inputs[0].engaged = 0;
    stitch.rest(5);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
}

// With one mouse Tab may pass by a driver on the way to another instrument.
TEST(Suturing, ADriverThatMakesRoomForAnotherInstrumentKeepsItsNeedle) {
    StitchOptions options;
    options.other = test::second_spec(ToolKind::kGrasper);
    options.other->hand = Hand::kRight;
    for (const double jaw_rad : {0.6, 0.0}) {
        Stitch stitch(options);
        stitch.driver(stitch.at(0), jaw_rad);
        stitch.rest(20);
        const auto in_jaws = [&] {
            return stitch.state.tools[0].proxy.inverse() * stitch.needle().needle;
        };
        const Pose held = in_jaws();
        stitch.events.clear();
        stitch.inputs[0].engaged = 0;
        stitch.inputs[0].jaw_rad = 0;
        stitch.rest(50);
        EXPECT_EQ(stitch.state.suturing.placed, 0) << "outside";
        EXPECT_EQ(stitch.state.suturing.driver, 0);
        Pose back = stitch.at(0);
        back.p.z() += 2e-3;
        stitch.driver(back, 0);
        stitch.rest(20);
        EXPECT_EQ(stitch.state.suturing.placed, 1);
        EXPECT_LT((in_jaws().p - held.p).norm(), 20e-6);
        EXPECT_LT(in_jaws().q.angularDistance(held.q), 0.01);
        EXPECT_EQ(stitch.find(EventKind::kNeedleReleased), nullptr);
        EXPECT_EQ(stitch.find(EventKind::kNeedleTaken), nullptr) << "not anew";
        // It came in closed; opening is not letting go yet, as at the beginning.
        stitch.jaw_rad = 0;
        stitch.jaws(0.6);
        EXPECT_EQ(stitch.state.suturing.driver, 0);
        stitch.jaws(0);
        stitch.jaws(0.6);
        EXPECT_EQ(stitch.state.suturing.driver, -1);
    }
}

TEST(Suturing, ANeedleInTissueStaysThereWhenItsDriverMakesRoom) {
    StitchOptions options;
    options.other = test::second_spec(ToolKind::kGrasper);
    options.other->hand = Hand::kRight;
    Stitch stitch(options);
    stitch.drive(4e-3, 20e-3);
    ASSERT_GT(stitch.needle().passage_count, 0);
    stitch.inputs[0].engaged = 0;
    stitch.rest(5);
    EXPECT_EQ(stitch.state.suturing.driver, -1);
    EXPECT_EQ(stitch.state.suturing.placed, 1);
    EXPECT_NE(stitch.find(EventKind::kNeedleReleased), nullptr);
}

TEST(Suturing, SlipInTheJawsIsOneEvent) {
    StitchOptions options;
    options.puncture_n = 1;  // nothing gives
    options.youngs_modulus_pa = 1e6;
    Stitch stitch(options);
    SutureSpec spec = stitch.scene.suture->spec();
    spec.jaws.force_n = 0.15;
    stitch.scene.suture.emplace(spec);
    stitch.drive(0.8e-3);
    stitch.drive(-0.8e-3);
    stitch.rest(150);
    const auto count = [&](EventKind kind) {
        return std::count_if(stitch.events.begin(), stitch.events.end(),
                             [&](const Event& e) { return e.kind == kind; });
    };
    const auto slips = count(EventKind::kNeedleSlipped) + count(EventKind::kNeedleTurned);
    EXPECT_GE(slips, 1);
    EXPECT_LE(slips, 3);
    const Event* turned = stitch.find(EventKind::kNeedleTurned);
    ASSERT_NE(turned, nullptr);
    EXPECT_GE(turned->value2, 0.3 * 0.15 * 2e-3 * 0.99) << "mu N w";
}

// Whoever ends the attempt while the needle slips has let it slip all the same.
TEST(Suturing, SlipThatTheAttemptsEndMeetsIsEntered) {
    Stitch stitch;
    stitch.rest(2);
    EXPECT_TRUE(open_spells(stitch.scene, stitch.state).empty());
    stitch.state.suturing.slide = {0.2F, 7, 0.05F};
    stitch.state.suturing.turn = {0.3F, 0.007F, 0};
    const std::vector<Event> open = open_spells(stitch.scene, stitch.state);
    ASSERT_EQ(open.size(), 2U);
    EXPECT_EQ(open[0].kind, EventKind::kNeedleSlipped);
    EXPECT_EQ(open[1].kind, EventKind::kNeedleTurned);
    EXPECT_EQ(open[1].tool, 0);
    EXPECT_EQ(open[1].value, 0.3F);
    EXPECT_EQ(open[1].value2, 0.007F);
}

/// A bite with thread, somewhere in its middle.
std::unique_ptr<Stitch> bitten(int threads, double path_m = 6e-3) {
    StitchOptions options;
    options.threads = threads;
    options.thread_m = 0.1;
    auto stitch = std::make_unique<Stitch>(options);
    stitch->drive(path_m, 20e-3);
    return stitch;
}

TEST(Suturing, ANeedleInTheTissueIsToldAtTheEnd) {
    const auto stitch = bitten(1);
    const std::vector<Event> open = open_spells(stitch->scene, stitch->state);
    const auto left_in = std::find_if(open.begin(), open.end(), [](const Event& e) {
        return e.kind == EventKind::kNeedleLeftIn;
    });
    ASSERT_NE(left_in, open.end());
    EXPECT_EQ(left_in->rest_position_m, stitch->state.suturing.entry_m);
}

TEST(Suturing, SameBitsAtAnyNumberOfThreads) {
    std::vector<uint64_t> hashes, whole;
    for (const int threads : {1, 2, 3}) {
        const auto stitch = bitten(threads);
        EXPECT_GT(stitch->needle().passage_count, 5);
        hashes.push_back(state_hash(stitch->state));
        whole.push_back(whole_hash(stitch->state));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
    EXPECT_EQ(whole[0], whole[1]);
    EXPECT_EQ(whole[0], whole[2]);
}

TEST(Suturing, WhatIsSavedInABiteGoesOnTheSame) {
    const auto first = bitten(1, 5e-3);
    const auto saved = save_state(first->scene, first->state);
    const auto second = bitten(1, 1e-3);
    ASSERT_NE(whole_hash(second->state), whole_hash(first->state));
    load_state(second->scene, second->state, saved);
    second->driven_m = first->driven_m;
    EXPECT_EQ(whole_hash(second->state), whole_hash(first->state));
    first->drive(4e-3, 20e-3, [&] {});
    second->drive(4e-3, 20e-3, [&] {});
    EXPECT_EQ(whole_hash(second->state), whole_hash(first->state));
    EXPECT_EQ(state_hash(second->state), state_hash(first->state));
    EXPECT_NE(first->find(EventKind::kNeedleLeft), nullptr);
}

TEST(Suturing, TheHashSeesTheNeedle) {
    const auto stitch = bitten(1, 2e-3);
    const uint64_t hash = state_hash(stitch->state), whole = whole_hash(stitch->state);
    const auto seen = [&](auto& value, auto other) {
        const auto before = value;
        value = other;
        EXPECT_NE(whole_hash(stitch->state), whole);
        const bool recorded = state_hash(stitch->state) != hash;
        value = before;
        return recorded;
    };
    EXPECT_TRUE(seen(stitch->needle().needle.p.x(), 0.1));
    EXPECT_TRUE(seen(stitch->needle().passages[0].sticks_at_m, 0.1));
    EXPECT_TRUE(seen(stitch->state.suturing.driver, int8_t{-1}));
    (void)seen(stitch->state.suturing.held_s, 3.0F);
    EXPECT_EQ(whole_hash(stitch->state), whole);
}

TEST(Suturing, ScratchMayBeLostBetweenAnyTwoFrames) {
    StitchOptions options;
    options.other = second_spec(ToolKind::kProbe);
    Stitch kept(options), lost(options);
    kept.inputs[1] = lost.inputs[1] = leaning(Vec3(3.3e-3, 0, -0.4e-3));
    for (int i = 0; i < 300; ++i) {
        kept.drive(20e-6, 20e-3);
        if (i % 2 == 0)
            lost.state.scratch = std::make_unique<State::Scratch>(lost.scene);
        else
            lost.state.scratch->forget();
        lost.drive(20e-6, 20e-3);
        ASSERT_EQ(whole_hash(lost.state), whole_hash(kept.state)) << i;
    }
    EXPECT_GT(kept.shared_vertices(), 0);
}

// Sleep is on in these scenes: tissue that the needle hangs in stays awake, and moves when it
// moves.
TEST(Suturing, TissueAroundANeedleDoesNotSleepThroughItsMotion) {
    Stitch stitch;
    stitch.drive(4e-3);
    stitch.rest(1500);
    const Vec3 before =
        place_of({stitch.scene.body, stitch.state.body, stitch.scene.surface, stitch.state.surface},
                 stitch.needle().passages[2].at);
    Pose aside = stitch.at(stitch.driven_m);
    for (int i = 1; i <= 50; ++i) {
        aside.p.y() += 8e-6;
        stitch.driver(aside);
        stitch.frame();
    }
    const Vec3 after =
        place_of({stitch.scene.body, stitch.state.body, stitch.scene.surface, stitch.state.surface},
                 stitch.needle().passages[2].at);
    EXPECT_GT((after - before).y(), 0.1e-3);
}

TEST(Suturing, AFrameAllocatesAndLocksNothing) {
    StitchOptions options;
    options.thread_m = 0.1;
    options.gravity = Vec3(0, 0, -9.81);
    Stitch stitch(options);
    stitch.rest(2);
    stitch.events.reserve(10000);
    const long before = placode::test::allocations + placode::test::locks;
    stitch.drive(6e-3, 20e-3);
    stitch.jaws(0.6);
    stitch.rest(50);
    stitch.jaws(0);
    stitch.drive(3e-3, 20e-3);
    EXPECT_EQ(placode::test::allocations + placode::test::locks, before);
    EXPECT_NE(stitch.find(EventKind::kNeedleEntered), nullptr);
}

// Hands that throw about driver, jaws and a probe: nothing is ever lost.
TEST(Suturing, BadHandsLeaveEverythingFinite) {
    for (const ToolKind kind : {ToolKind::kProbe, ToolKind::kGrasper}) {
        StitchOptions options;
        options.other = second_spec(kind);
        options.thread_m = 0.03;
        options.gravity = Vec3(0, 0, -9.81);
        Stitch stitch(options);
        stitch.inputs[1] = test::upright(Vec3(2e-3, 0, 3e-3));
        stitch.drive(3e-3, 20e-3);
        Dice dice;
        for (int i = 0; i < 1200; ++i) {
            Pose hand = stitch.at(stitch.driven_m);
            hand.p += 3e-3 * dice.place();
            hand.q = hand.q * turned(1.5 * dice(), dice.place().normalized());
            stitch.driver(hand, i % 100 < 70 ? 0.0 : 0.6);
            stitch.inputs[1] = test::upright(Vec3(3e-3 * dice(), 1e-3 * dice(), 1e-3 * dice()));
            stitch.inputs[1].jaw_rad = i % 60 < 30 ? 0.0F : 0.6F;
            if (i % 250 == 249) stitch.inputs[0].engaged = 0;
            stitch.frame();
            ASSERT_TRUE(stitch.finite()) << i;
            ASSERT_LT(stitch.needle().needle.p.norm(), 0.05) << i;
        }
        stitch.inputs[0].engaged = stitch.inputs[1].engaged = 0;
        stitch.rest(3);
        EXPECT_TRUE(std::all_of(stitch.state.scratch->suture[0].slot.begin(),
                                stitch.state.scratch->suture[0].slot.end(),
                                [](int32_t s) { return s < 0; }));
        EXPECT_TRUE(std::all_of(stitch.state.body.contact_vertex.begin(),
                                stitch.state.body.contact_vertex.end(),
                                [](uint8_t c) { return c == 0; }));
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim

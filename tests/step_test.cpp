// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step as a whole: same bits, no allocation, and what it writes into the ledger.

#include "sim/step/step.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

#include "sim/step/snapshot.h"
#include "sim/step/tip_gap.h"
#include "tests/box_scene.h"
#include "tests/instruction_sets.h"

namespace {
std::atomic<bool> g_watching{false};
std::atomic<int> g_allocations{0};
}  // namespace

// Counts every allocation of the process while `g_watching` is set. Not inlined, because g++ would
// then see malloc's pointer in delete and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (g_watching) ++g_allocations;
    if (void* p = std::malloc(size ? size : 1)) return p;
    throw std::bad_alloc();
}
// std::stable_sort asks so.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (g_watching) ++g_allocations;
    return std::malloc(size ? size : 1);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace placode::sim {
namespace THIS_TEST {

using test::BoxOptions;
using test::frame;
using test::upright;

BoxOptions small_box(Tissue tissue = Tissue::kZone) {
    BoxOptions options;
    options.size_m = Vec3(0.005, 0.005, 0.002);
    options.cells = {10, 10, 6};
    options.tissue = tissue;
    options.material.youngs_modulus_pa = 10000;
    options.material.damping_per_s = 30;
    return options;
}

/// A short stroke with the cutting pedal down; returns all events.
std::vector<Event> stroke(const Scene& scene, State& state, int frames) {
    std::vector<Event> events;
    ToolFeedback feedback;
    for (int i = 0; i < frames; ++i) {
        const double z = std::max(-0.0002, 0.0005 - 0.00002 * i);
        frame(scene, state, upright(Vec3(-0.0005 + 3e-6 * i, 0.0001, z), kPedalCut), feedback);
        events.insert(events.end(), state.events.begin(), state.events.begin() + state.event_count);
    }
    return events;
}

int count(const std::vector<Event>& events, EventKind kind) {
    int n = 0;
    for (const Event& e : events) n += e.kind == kind;
    return n;
}

TEST(Step, TheHashIsTheSameForOneTwoAndFourThreads) {
    const Scene scene = test::box_scene(small_box());
    placode::test::with_every_instruction_set([&] {
        uint64_t first = 0;
        for (const int threads : {1, 2, 3, 4}) {
            State state(scene, threads);
            const auto events = stroke(scene, state, 400);
            EXPECT_GT(count(events, EventKind::kVaporised), 0);
            const uint64_t hash = state_hash(state);
            if (threads == 1) first = hash;
            EXPECT_EQ(hash, first) << threads << " threads, " << kernel_target();
        }
    });
}

TEST(Step, TheHashSeesOneBitOfTheInput) {
    const Scene scene = test::box_scene(small_box());
    State a(scene, 1), b(scene, 1);
    ToolFeedback feedback;
    ToolInput input = upright(Vec3(0, 0, -0.0001));
    for (int i = 0; i < 5; ++i) frame(scene, a, input, feedback);
    input.position_m[0] = 1e-9f;
    for (int i = 0; i < 5; ++i) frame(scene, b, input, feedback);
    EXPECT_NE(state_hash(a), state_hash(b));
}

TEST(Step, NothingIsAllocatedWhileCutting) {
    const Scene scene = test::box_scene(small_box());
    State state(scene, 2);
    ToolFeedback feedback;
    g_allocations = 0;
    g_watching = true;
    for (int i = 0; i < 300; ++i) {
        const double z = std::max(-0.0002, 0.0005 - 0.00002 * i);
        frame(scene, state, upright(Vec3(3e-6 * i, 0, z), kPedalCut), feedback);
    }
    g_watching = false;
    EXPECT_EQ(g_allocations, 0);
    EXPECT_GT(state.removed_m3, 0);
    // The counter itself works.
    g_watching = true;
    const std::vector<int64_t> witness(static_cast<size_t>(state.frame), state.frame);
    g_watching = false;
    EXPECT_EQ(witness.back(), 300);
    EXPECT_EQ(g_allocations, 1);
}

TEST(Step, EnergyInTheAirIsNotedWhenItEnds) {
    const Scene scene = test::box_scene(small_box());
    State state(scene, 1);
    ToolFeedback feedback;
    std::vector<Event> events;
    for (int i = 0; i < 2300; ++i) {  // it ends when a second has passed without current
        const uint8_t pedal = i < 1200 ? kPedalCut : 0;
        frame(scene, state, upright(Vec3(0, 0, 0.01), pedal), feedback);
        events.insert(events.end(), state.events.begin(), state.events.begin() + state.event_count);
    }
    ASSERT_EQ(count(events, EventKind::kEnergyInAir), 1);
    EXPECT_EQ(count(events, EventKind::kEnergyOn), 1);
    EXPECT_EQ(count(events, EventKind::kEnergyOff), 1);
    EXPECT_EQ(count(events, EventKind::kStateHash), 2);
    for (const Event& e : events) {
        if (e.kind == EventKind::kEnergyInAir) {
            EXPECT_NEAR(e.value, 1.2, 0.002);
            EXPECT_NEAR(e.time_s, 1.2, 0.002);
        }
        if (e.kind == EventKind::kEnergyOff) {
            EXPECT_EQ(e.value2, 0);
        }
        if (e.kind == EventKind::kStateHash) {
            EXPECT_NEAR(e.time_s, std::round(e.time_s), 1e-9);
        }
    }
}

TEST(Step, AnEnergisedNeedleOnThePlacodeBurnsIt) {
    const Scene scene = test::box_scene(small_box(Tissue::kPlacode));
    State state(scene, 1);
    ToolFeedback feedback;
    std::vector<Event> events;
    for (int i = 0; i < 400; ++i) {
        const double z = std::max(-0.0001, 0.0005 - 0.00002 * i);
        const uint8_t pedal = i > 50 && i < 350 ? kPedalCoag : 0;
        frame(scene, state, upright(Vec3(0, 0, z), pedal), feedback);
        events.insert(events.end(), state.events.begin(), state.events.begin() + state.event_count);
    }
    EXPECT_GE(count(events, EventKind::kPlacodeEnergised), 1);
    EXPECT_GE(count(events, EventKind::kPlacodeOverheated), 1);
    EXPECT_GE(count(events, EventKind::kPlacodeBurned), 1);
    EXPECT_EQ(count(events, EventKind::kVaporised), 0) << "coagulation removes nothing";
    EXPECT_GT(state.ledger.placode_peak_c, 60);
    EXPECT_GT(state.ledger.placode_peak_cem43_min, 20);
    EXPECT_GT(state.ledger.placode_burned_m3, 0);
}

TEST(Step, AnEnergyFreeFirstTouchBeginsTheIncision) {
    const Scene scene = test::box_scene(small_box());
    State state(scene, 1);
    ToolFeedback feedback;
    frame(scene, state, upright(Vec3(0, 0, 0.01)), feedback);
    EXPECT_EQ(state.phase, Phase::kInspect);
    for (int i = 0; i < 60; ++i) {
        frame(scene, state, upright(Vec3(0, 0, std::max(-0.0002, 0.0005 - 0.00002 * i))), feedback);
    }
    EXPECT_EQ(state.phase, Phase::kIncise);
    EXPECT_EQ(state.tools[0].touched, Tissue::kZone);
}

TEST(Step, SettlingLeavesTheTissueAtRest) {
    BoxOptions options = small_box();
    options.gravity = Vec3(0, 0, -9.81);
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    settle(scene, state, 0.5);
    EXPECT_EQ(state.frame, 0);
    const auto before = state.body.x;
    ToolFeedback feedback;
    for (int i = 0; i < 100; ++i) frame(scene, state, upright(Vec3(0, 0, 0.02)), feedback);
    double moved = 0;
    for (size_t v = 0; v < before.size(); ++v) {
        moved = std::max(moved, static_cast<double>(std::abs(state.body.x[v].z - before[v].z)));
    }
    // Sag of 2 mm of tissue at 10 kPa: rho g L^2 / 2E = 2 um; what is left is below 2 % of that.
    EXPECT_LT(moved, 4e-8);
}

// In a frame up to 3 mm; for a step that asks for more as far as is asked.
TEST(Step, ATipIsAsFarFromTheTissueAsItIs) {
    BoxOptions options = small_box();
    options.heat = false;
    const Scene scene = test::box_scene(options);
    for (const double above_m : {0.002, 0.004, 0.009}) {
        State state(scene, 1);
        ToolFeedback feedback;
        frame(scene, state, upright(Vec3(0, 0, above_m)), feedback);
        EXPECT_NEAR(state.tools[0].tip_gap_m, above_m < 0.003 ? above_m : 1, 1e-6);
        EXPECT_NEAR(tip_gap(state, 0, 0.010), above_m, 1e-6);
        EXPECT_EQ(tip_gap(state, 0, above_m - 1e-4), 1) << "further than is asked";
    }
}

TEST(Step, TheSnapshotShowsTheStateAndReusesItsMemory) {
    const Scene scene = test::box_scene(small_box());
    State state(scene, 1);
    stroke(scene, state, 300);
    Snapshot snapshot;
    fill_snapshot(scene, state, snapshot);
    EXPECT_EQ(snapshot.x.size(), state.body.x.size());
    EXPECT_EQ(snapshot.triangles.size(), state.surface.triangles().size());
    EXPECT_EQ(snapshot.tool_count, 1);
    EXPECT_EQ(snapshot.tools[0].energised, 1);
    EXPECT_EQ(snapshot.tools[0].pedals, kPedalCut);
    float hottest = 0;
    for (const auto& d : snapshot.damage) hottest = std::max(hottest, d[3]);
    EXPECT_GT(hottest, 90);
    g_allocations = 0;
    g_watching = true;
    fill_snapshot(scene, state, snapshot);
    g_watching = false;
    EXPECT_EQ(g_allocations, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state is whole: what is saved goes on as if nothing had happened, scratch may be lost between
// any two frames, and the hash sees all that decides.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

#include "sim/step/step.h"
#include "sim/world/saved_state.h"
#include "sim/world/scratch.h"
#include "tests/rerun.h"

namespace placode {
namespace THIS_TEST {

struct Case {
    const char* task;
    double begin_s, end_s;  ///< The state is saved at `begin_s`, both go on to `end_s`.
    bool at_work = false;   ///< By then tissue was cut or a needle is in it.
};

// Long enough for the instrument to be at work where it is saved. PLACODE_LONG_TESTS goes on for
// ten seconds in every task.
std::vector<Case> cases() {
    if (std::getenv("PLACODE_LONG_TESTS") == nullptr)
        return {{"diathermy_ring_small", 4, 5, true},
                {"scissors_resection", 16, 16.5, true},
                {"suture_slit", 7, 7.2, true}};
    std::vector<Case> all;
    for (const char* task :
         {"familiarisation", "touch_targets", "trace_contour", "grasp_and_lift",
          "two_handed_traction", "diathermy_ring_small", "diathermy_ring", "scissors_resection",
          "sb_dissection", "sb_dissection_cystic", "suture_bite", "suture_run", "suture_slit"})
        all.push_back({task, 6, 16});
    return all;
}

TEST(WholeState, WhatIsSavedGoesOnAsIfNothingHadHappened) {
    for (const Case& what : cases()) {
        SCOPED_TRACE(what.task);
        const test::Rerun rerun(what.task, what.end_s);
        const auto started = rerun.start();
        sim::State& state = *started;
        rerun.step_to(state, static_cast<int64_t>(1000 * what.begin_s));
        const auto saved = sim::save_state(*rerun.scene, state);
        sim::State copy(*rerun.scene, 2);
        ASSERT_NE(sim::whole_hash(copy), sim::whole_hash(state));
        sim::load_state(*rerun.scene, copy, saved);
        ASSERT_EQ(sim::whole_hash(copy), sim::whole_hash(state));
        EXPECT_TRUE(sim::save_state(*rerun.scene, copy) == saved) << "saved again it is the same";
        EXPECT_TRUE(!what.at_work || state.removed_m3 > 0 || state.splits > 0 ||
                    state.suturing.entered > 0)
            << "nothing was cut or entered yet: the test would see little";
        while (state.frame < rerun.frames()) {
            rerun.step(state);
            rerun.step(copy);
            ASSERT_EQ(copy.event_count, state.event_count) << state.frame;
            if (state.frame % 20 == 0) {
                ASSERT_EQ(sim::whole_hash(copy), sim::whole_hash(state)) << state.frame;
            }
        }
        EXPECT_EQ(sim::state_hash(copy), sim::state_hash(state));
    }
}

TEST(WholeState, ScratchMayBeLostBetweenAnyTwoFrames) {
    const Case what = {"scissors_resection", 16, 16.2};
    const test::Rerun rerun(what.task, what.end_s);
    const auto started = rerun.start();
    sim::State& state = *started;
    rerun.step_to(state, static_cast<int64_t>(1000 * what.begin_s));
    sim::State forgetful(*rerun.scene, 1);
    sim::load_state(*rerun.scene, forgetful, sim::save_state(*rerun.scene, state));
    while (state.frame < rerun.frames()) {
        rerun.step(state);
        if (state.frame % 2 == 0)
            forgetful.scratch = std::make_unique<sim::State::Scratch>(*rerun.scene);
        else
            forgetful.scratch->forget();
        rerun.step(forgetful);
        ASSERT_EQ(sim::whole_hash(forgetful), sim::whole_hash(state)) << state.frame;
    }
}

TEST(WholeState, TheHashSeesWhatWaitsForTheNextFrames) {
    const test::Rerun rerun("diathermy_ring_small", 0.1);
    const auto started = rerun.start();
    sim::State& state = *started;
    const uint64_t before = sim::whole_hash(state);
    const auto changes = [&](auto&& change, auto&& back) {
        change();
        const bool seen = sim::whole_hash(state) != before;
        back();
        EXPECT_EQ(sim::whole_hash(state), before);
        return seen;
    };
    EXPECT_TRUE(changes([&] { ++state.separation.count; }, [&] { --state.separation.count; }));
    EXPECT_TRUE(changes([&] { state.flood.running = 1; }, [&] { state.flood.running = 0; }));
    EXPECT_TRUE(changes([&] { state.ledger.tools[0].dwell_s += 1; },
                        [&] { state.ledger.tools[0].dwell_s -= 1; }));
    EXPECT_TRUE(changes([&] { state.gone_by_heat[5] = 1; }, [&] { state.gone_by_heat[5] = 0; }));
    EXPECT_TRUE(
        changes([&] { state.friction[7].slipping = 3; }, [&] { state.friction[7].slipping = 0; }));
    EXPECT_TRUE(
        changes([&] { state.heat[0].energy_in_j += 1; }, [&] { state.heat[0].energy_in_j -= 1; }));
}

TEST(WholeState, OtherBytesAreRefusedAndChangeNothing) {
    const test::Rerun rerun("diathermy_ring_small", 0.1);
    const auto started = rerun.start();
    sim::State& state = *started;
    const auto saved = sim::save_state(*rerun.scene, state);
    rerun.step(state);
    const uint64_t before = sim::whole_hash(state);
    const auto refused = [&](std::vector<uint8_t> bytes, const char* why) {
        try {
            sim::load_state(*rerun.scene, state, bytes);
            ADD_FAILURE() << "accepted: " << why;
        } catch (const sim::StateError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(why));
        }
        EXPECT_EQ(sim::whole_hash(state), before);
    };
    sim::load_own_state(state, saved);
    EXPECT_TRUE(sim::save_state(*rerun.scene, state) == saved);
    rerun.step(state);
    EXPECT_EQ(sim::whole_hash(state), before) << "the frame after it is the same";
    for (const size_t size : {size_t{0}, size_t{20}, size_t{40}, saved.size() - 1})
        EXPECT_THROW(sim::load_own_state(state, std::span(saved).first(size)), sim::StateError);
    refused({}, "cut off");
    refused({saved.begin(), saved.begin() + 40}, "cut off or damaged");
    auto damaged = saved;
    damaged[saved.size() / 2] ^= 1;
    refused(damaged, "damaged");
    auto other = saved;
    other[0] ^= 1;
    refused(other, "another format");
    const test::Rerun larger("scissors_resection", 0.05);
    refused(sim::save_state(*larger.scene, *larger.start()), "another scene");
}

}  // namespace THIS_TEST
}  // namespace placode

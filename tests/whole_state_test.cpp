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
#include "tests/live_attempt.h"

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
    for (const char* task : {"touch_targets", "grasp_and_lift", "diathermy_ring_small",
                             "diathermy_ring", "scissors_resection", "sb_dissection",
                             "sb_dissection_cystic", "suture_run", "suture_slit", "patch_place",
                             "irrigate", "undermine", "needle_handover", "wound_closure"})
        all.push_back({task, 6, 16});
    // The operator has finished these 12 to 16 s after the begin.
    for (const char* task :
         {"familiarisation", "trace_contour", "two_handed_traction", "suture_bite"})
        all.push_back({task, 2, 12});
    return all;
}

/// What an attempt saved, and how it went on from there.
struct Course {
    /// @param each  The whole is hashed after so many frames one by one, then after every 20th: it
    ///              takes longer than the frame itself.
    explicit Course(const Case& what, size_t each = 0) : attempt(what.task, what.end_s) {
        sim::State& state = attempt.state();
        attempt.step_to(static_cast<int64_t>(1000 * what.begin_s));
        saved = sim::save_state(attempt.scene(), state);
        saved_hash = sim::whole_hash(state);
        at_work = state.removed_m3 > 0 || state.splits > 0 || state.suturing.entered > 0 ||
                  state.suturing.handover.last >= 0;
        begin = state.frame;
        while (!attempt.over()) {
            attempt.step();
            const bool due = hashes.size() < each || state.frame % 20 == 0;
            hashes.push_back(due ? sim::whole_hash(state) : 0);
            event_counts.push_back(state.event_count);
        }
        last_hash = sim::state_hash(state);
        inputs = attempt.recording().inputs;
    }
    [[nodiscard]] const sim::Scene& scene() const { return attempt.scene(); }
    /// From the saved frame on.
    [[nodiscard]] int64_t frames() const { return std::ssize(hashes); }
    void step(sim::State& other) const {
        test::step_with(scene(), other, inputs.at(static_cast<size_t>(other.frame)));
    }
    /// Of the frame that `other` has reached.
    [[nodiscard]] size_t at(const sim::State& other) const {
        return static_cast<size_t>(other.frame - begin - 1);
    }

    test::LiveAttempt attempt;
    std::vector<uint8_t> saved;
    uint64_t saved_hash = 0, last_hash = 0;
    bool at_work = false;
    int64_t begin = 0;
    std::vector<uint64_t> hashes;  ///< Whole, after each frame; 0 = not taken.
    std::vector<int> event_counts;
    std::vector<sim::Input> inputs;
};

constexpr int kForgetfulFrames = 200;

/// Scissors at work, for more than one test.
const Course& resection() {
    static const Course course({"scissors_resection", 16, 16.5}, kForgetfulFrames);
    return course;
}

void expect_that_a_copy_goes_on(const Course& course) {
    sim::State copy(course.scene(), 2);
    ASSERT_NE(sim::whole_hash(copy), course.saved_hash);
    sim::load_state(course.scene(), copy, course.saved);
    ASSERT_EQ(sim::whole_hash(copy), course.saved_hash);
    EXPECT_TRUE(sim::save_state(course.scene(), copy) == course.saved)
        << "saved again it is the same";
    for (int64_t i = 0; i < course.frames(); ++i) {
        course.step(copy);
        ASSERT_EQ(copy.event_count, course.event_counts[course.at(copy)]) << copy.frame;
        if (copy.frame % 20 == 0) {
            ASSERT_EQ(sim::whole_hash(copy), course.hashes[course.at(copy)]) << copy.frame;
        }
    }
    EXPECT_EQ(sim::state_hash(copy), course.last_hash);
}

TEST(WholeState, WhatIsSavedGoesOnAsIfNothingHadHappened) {
    for (const Case& what : cases()) {
        SCOPED_TRACE(what.task);
        const bool shared = std::string(what.task) == "scissors_resection" && what.at_work;
        const auto own = shared ? nullptr : std::make_unique<Course>(what);
        const Course& course = shared ? resection() : *own;
        EXPECT_GE(course.frames(), static_cast<int64_t>(1000 * (what.end_s - what.begin_s)) - 1);
        EXPECT_TRUE(!what.at_work || course.at_work)
            << "nothing was cut or entered yet: the test would see little";
        expect_that_a_copy_goes_on(course);
    }
}

TEST(WholeState, ScratchMayBeLostBetweenAnyTwoFrames) {
    const Course& course = resection();
    sim::State forgetful(course.scene(), 1);
    sim::load_state(course.scene(), forgetful, course.saved);
    for (int frame = 0; frame < kForgetfulFrames; ++frame) {
        if (forgetful.frame % 2 == 1)
            forgetful.scratch = std::make_unique<sim::State::Scratch>(course.scene());
        else
            forgetful.scratch->forget();
        course.step(forgetful);
        ASSERT_EQ(sim::whole_hash(forgetful), course.hashes[course.at(forgetful)])
            << forgetful.frame;
    }
}

TEST(WholeState, TheHashSeesWhatWaitsForTheNextFrames) {
    test::LiveAttempt attempt("diathermy_ring_small");
    sim::State& state = attempt.state();
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
    test::LiveAttempt attempt("diathermy_ring_small");
    sim::State& state = attempt.state();
    const sim::Scene& scene = attempt.scene();
    const auto saved = sim::save_state(scene, state);
    attempt.step();
    const uint64_t before = sim::whole_hash(state);
    const auto refused = [&](std::vector<uint8_t> bytes, const char* why) {
        try {
            sim::load_state(scene, state, bytes);
            ADD_FAILURE() << "accepted: " << why;
        } catch (const sim::StateError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(why));
        }
        EXPECT_EQ(sim::whole_hash(state), before);
    };
    sim::load_own_state(state, saved);
    EXPECT_TRUE(sim::save_state(scene, state) == saved);
    test::step_with(scene, state, attempt.input());
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
    refused(resection().saved, "another scene");
}

}  // namespace THIS_TEST
}  // namespace placode

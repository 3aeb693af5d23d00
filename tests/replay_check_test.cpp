// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An honest attempt is found to be what it is, in every shipped task; a changed one is not.

#include "curriculum/replay_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/attempt_fixture.h"
#include "tests/bars.h"

using namespace placode;
using namespace placode::curriculum;
using sim::EventKind;
using sim::Recording;

namespace THIS_TEST {

/// All of it at once.
ReplayVerdict check_replay(const Recording& recording, const Task& published, int threads) {
    ReplayCheck check(recording, published, threads);
    while (check.step()) {
    }
    return check.verdict();
}

TEST(ReplayCheck, AnHonestAttemptOfEveryTaskIsIdentical) {
    // In a long run 500 of all tasks, by three levels of operators, each to a time of its own.
    test::Bar bar("honest attempts that replay otherwise");
    const std::vector<std::string> tasks = list_definitions("tasks");
    constexpr const char* kLevels[]{"novice", "expert", "intermediate"};
    const int rounds = test::times(1, 1 + 500 / static_cast<int>(tasks.size()));
    for (int round = 0; round < rounds; ++round) {
        for (const std::string& id : tasks) {
            const Recording honest = test::scripted_seconds(id, 1.5 + round % 7, kLevels[round % 3],
                                                            3 + static_cast<uint64_t>(round));
            ASSERT_GT(honest.samples.size(), 100U) << id;
            const ReplayVerdict verdict = check_replay(honest, load_task(id), 2);
            EXPECT_TRUE(verdict.identical)
                << id << " " << round << ": " << verdict.difference.english();
            bar.tried(verdict.identical);
        }
    }
}

TEST(ReplayCheck, AnAttemptThatCameToItsOwnEndIsIdentical) {
    const Recording honest = test::scripted_seconds("touch_targets", 0);
    ASSERT_EQ(honest.end.reason, sim::EndReason::kFinished);
    const ReplayVerdict verdict = check_replay(honest, load_task("touch_targets"), 1);
    EXPECT_TRUE(verdict.identical) << verdict.difference.english();
}

TEST(ReplayCheck, WhatWasChangedIsNamed) {
    const Task task = test::tiny_task("diathermy_ring_small");
    const Recording honest = test::scripted_seconds(task, 1.5);
    const size_t middle = honest.samples.size() / 2;
    struct Change {
        const char* named;
        std::function<void(Recording&)> make;
    };
    const Change changes[]{
        {"a sample", [&](Recording& r) { r.samples[middle].cut_fraction = 1; }},
        {"a sample", [&](Recording& r) { r.samples[middle].tools[0].tip_m[2] += 1e-4F; }},
        {"a sample", [&](Recording& r) { r.samples[middle].tools[0].force_n[0] = 0.5F; }},
        {"a sample", [&](Recording& r) { r.samples[middle].placode_burned_m3 += 1e-12F; }},
        {"a sample", [&](Recording& r) { r.samples.erase(r.samples.begin() + 20); }},
        {"number of samples", [&](Recording& r) { r.samples.push_back(r.samples.back()); }},
        {"event", [&](Recording& r) { r.events.erase(r.events.begin()); }},
        {"event",
         [&](Recording& r) {
             sim::Event more;
             more.time_s = 0.5;
             more.kind = EventKind::kPhase;
             r.events.insert(r.events.begin(), more);
         }},
        {"state",
         [&](Recording& r) {
             r.inputs[500].tools[0].position_m[0] += 1e-3F;
             for (size_t i = 500; i < 1100; ++i) r.inputs[i].tools[0].position_m[0] += 1e-3F;
         }},
        {"frame or sample time", [&](Recording& r) { r.header.sample_s = 0.02; }},
        {"the field", [&](Recording& r) { r.header.geometry.placode_volume_m3 *= 10; }},
        {"the field", [&](Recording& r) { r.header.geometry.planned_contour.clear(); }},
        {"the instruments", [&](Recording& r) { r.header.tools[0].tip_radius_m *= 2; }},
        {"duration", [&](Recording& r) { r.end.duration_s -= 0.2; }},
        {"state", [&](Recording& r) { r.end.final_hash ^= 1; }},
        {"", [&](Recording& r) { r.header.seed = 4; }},
    };
    int at = 0;
    for (const Change& change : changes) {
        Recording forged = honest;
        change.make(forged);
        const ReplayVerdict verdict = check_replay(forged, task, 1);
        EXPECT_FALSE(verdict.identical) << "change " << at;
        // A hand that is moved shows in the samples first.
        if (std::string(change.named) != "state") {
            EXPECT_THAT(verdict.difference.english(), testing::HasSubstr(change.named))
                << "change " << at;
        }
        ++at;
    }
}

TEST(ReplayCheck, TheTaskThatTheFileCarriesIsNotUsed) {
    const Recording honest = test::scripted_seconds("touch_targets", 0.5);
    Recording forged = honest;
    forged.header.task_json = load_task("diathermy_ring").json;
    EXPECT_TRUE(check_replay(forged, load_task("touch_targets"), 1).identical);
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scripted operators differ by what they do to the tissue, and the score sees it: whole
// attempts on the warm-up field, simulated, measured and scored.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "tests/attempt_fixture.h"

using namespace placode;

namespace THIS_TEST {

struct Attempt {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
};

Attempt perform(const std::string& level) {
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    Attempt attempt;
    attempt.recording = test::scripted_attempt(task, level);
    attempt.metrics = assessment::compute_metrics(attempt.recording);
    attempt.score = assessment::score_attempt(task.rubric, attempt.metrics, attempt.recording);
    return attempt;
}

using sim::EventKind;

/// What must have happened for points to be lost for an item.
const std::map<std::string, std::vector<EventKind>>& evidence() {
    static const std::map<std::string, std::vector<EventKind>> kinds{
        {"placode_cut", {EventKind::kVaporised, EventKind::kTorn}},
        {"placode_energised", {EventKind::kPlacodeEnergised}},
        {"placode_burned", {EventKind::kPlacodeBurned}},
        {"placode_burned_badly", {EventKind::kPlacodeBurned}},
        {"placode_overheated", {EventKind::kPlacodeOverheated}},
        {"placode_touched", {EventKind::kPlacodeContact}},
        {"placode_contact_time", {EventKind::kPlacodeContact}},
        {"placode_pressed", {EventKind::kPlacodeContact}},
        {"toward_placode", {EventKind::kVaporised}},
        {"outside_band", {EventKind::kVaporised}},
        {"off_line", {EventKind::kVaporised}},
        {"stretched", {EventKind::kStretchSum}},
        {"torn", {EventKind::kTorn}},
        {"over_force", {EventKind::kOverForce}},
        {"dwell", {EventKind::kDwell}},
        {"buried", {EventKind::kBuried}},
        {"energy_in_air", {EventKind::kEnergyInAir}},
    };
    return kinds;
}

/// The ledger has an event of the reason's kind at the reason's moment. What lasts was written down
/// at its end, and its reason shows its beginning.
bool stands_in_recording(const std::string& item, double time_s, const sim::Recording& recording) {
    constexpr double kNearS = 0.002;  // Two frames: recordings keep times as they were.
    for (const sim::Event& event : recording.events) {
        if (std::ranges::count(evidence().at(item), event.kind) == 0) continue;
        if (item == "placode_cut" && event.tissue != sim::Tissue::kPlacode) continue;
        if (std::abs(event.time_s - time_s) < kNearS ||
            std::abs(event.time_s - event.value - time_s) < kNearS)
            return true;
    }
    return false;
}

TEST(OperatorLevels, ExpertAboveIntermediateAboveNoviceWithReasonsInTheRecording) {
    auto later = std::async(std::launch::async, [] { return perform("novice"); });
    const Attempt expert = perform("expert"), intermediate = perform("intermediate"),
                  novice = later.get();
    EXPECT_EQ(expert.score.verdict, assessment::Verdict::kPassed) << expert.score.points;
    EXPECT_GE(*expert.metrics.find("ring_completeness_percent"), 99);
    EXPECT_EQ(*expert.metrics.find("placode_burned_percent"), 0);
    EXPECT_GT(expert.score.points, intermediate.score.points);
    EXPECT_GT(intermediate.score.points, novice.score.points);
    int with_a_time = 0;
    for (const Attempt* attempt : {&expert, &intermediate, &novice}) {
        EXPECT_EQ(attempt->recording.end.dropped, 0);
        ASSERT_FALSE(attempt->score.reasons.empty());
        for (const auto& reason : attempt->score.reasons) {
            if (reason.time_s < 0) continue;  // about the whole attempt
            ASSERT_TRUE(evidence().contains(reason.item)) << reason.item;
            EXPECT_TRUE(stands_in_recording(reason.item, reason.time_s, attempt->recording))
                << reason.text;
            ++with_a_time;
            // Kinds that are rare: a wrong time has nothing to stand on.
            const bool rare = evidence().at(reason.item).front() != EventKind::kVaporised;
            if (rare) {
                EXPECT_FALSE(
                    stands_in_recording(reason.item, reason.time_s + 0.437, attempt->recording))
                    << reason.text;
            }
        }
    }
    EXPECT_GE(with_a_time, 8);
}

}  // namespace THIS_TEST

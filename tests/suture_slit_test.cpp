// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of closing a slit: whole attempts, and what is left of the gap.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/closure.h"
#include "assessment/leak_map.h"
#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "sim/contact/slit_gap.h"
#include "sim/step/snapshot.h"
#include "tests/attempt_fixture.h"
#include "tests/judged_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

/// Through the open slit: Torricelli, 0.6 of an ellipse of 12 x 1 mm less the 50 um that contact
/// keeps walls apart and that count as shut.
double open_leak_ml_min() {
    const double area_m2 = 0.25 * std::numbers::pi * 12e-3 * 1e-3 - 12e-3 * 50e-6;
    return 6e7 * 0.6 * area_m2 * std::sqrt(2 * assessment::kLeakPa / 1005);
}

using test::judged;
using test::Outcome;

Outcome perform(const std::string& level, uint64_t seed) {
    const Task task = load_task("suture_slit");
    Outcome out = judged(task, test::recorded(task, seed, test::scripted(level)));
    for (const assessment::Metric& metric : out.metrics.values)
        ::testing::Test::RecordProperty(level + "_" + metric.id, std::to_string(metric.value));
    ::testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform("expert", 1);
    return outcome;
}

/// Height of the tissue at a place of the plane [m], by its highest triangle there.
double height_at(const sim::Snapshot& seen, double x, double y) {
    double highest = -1;
    for (const sim::SurfaceTriangle& t : seen.triangles) {
        std::array<sim::Vec3, 3> p;
        for (size_t k = 0; k < 3; ++k) {
            const auto& at = seen.x[static_cast<size_t>(t.vertex[k])];
            p[k] = sim::Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]),
                             static_cast<double>(at[2]));
        }
        const auto cross = [&](const sim::Vec3& a, const sim::Vec3& b) {
            return (a.x() - x) * (b.y() - y) - (a.y() - y) * (b.x() - x);
        };
        const double area = cross(p[0], p[1]) + cross(p[1], p[2]) + cross(p[2], p[0]);
        const double a = cross(p[1], p[2]), b = cross(p[2], p[0]), c = cross(p[0], p[1]);
        if (!(area > 0) || a < 0 || b < 0 || c < 0) continue;
        highest = std::max(highest, (a * p[0].z() + b * p[1].z() + c * p[2].z()) / area);
    }
    return highest;
}

/// Stretches of the thread, from the needle to its tail, that are seen from above [m].
std::vector<double> seen_stretches_m(const sim::Snapshot& seen) {
    std::vector<double> stretches;
    sim::Vec3 last = sim::Vec3::Zero();
    bool was_seen = false;
    for (const auto& point : seen.needle.thread) {
        const sim::Vec3 p(static_cast<double>(point[0]), static_cast<double>(point[1]),
                          static_cast<double>(point[2]));
        const bool seen_now = p.z() > height_at(seen, p.x(), p.y());
        if (seen_now && !was_seen) stretches.push_back(0);
        if (seen_now && was_seen) stretches.back() += (p - last).norm();
        was_seen = seen_now;
        last = p;
    }
    return stretches;
}

TEST(SutureSlit, AnExpertShutsTheSlit) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("bites_done"), 3);
    EXPECT_EQ(run.value("needle_entries"), 3);
    EXPECT_EQ(run.value("thread_cuts"), 0);
    EXPECT_EQ(run.value("torn_volume_mm3"), 0);
    // Open it gapes by 0.95 mm, 0.7 in the mean.
    EXPECT_GT(run.value("slit_shut_percent"), 95);
    EXPECT_LT(run.value("slit_gap_widest_mm"), 0.2);
    EXPECT_LT(run.value("slit_gap_mean_mm"), 0.1);
    EXPECT_LT(run.value("slit_leak_6_ml_min"), 10);
    EXPECT_GT(run.value("slit_burst_cmh2o"), 12.5);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(SutureSlit, WhoSewsBadlyLeavesItOpenAndScoresFarLess) {
    const Outcome bad = perform("novice", 1);
    EXPECT_LT(bad.score.points, expert().score.points - 50);
    EXPECT_EQ(bad.score.verdict, assessment::Verdict::kFailed) << "what leaks is no closure";
    EXPECT_GT(bad.value("slit_gap_mean_mm"), 0.2);
    EXPECT_LT(bad.value("slit_shut_percent"), 60);
    EXPECT_LT(bad.value("slit_burst_cmh2o"), 6);
    EXPECT_GT(bad.value("slit_leak_6_ml_min"), 0.2 * open_leak_ml_min());
    EXPECT_EQ(bad.value("over_force_count"), 0) << "tears nothing by brute force";
}

TEST(SutureSlit, AnIntermediateMakesItTightButNotAsWell) {
    const Outcome run = perform("intermediate", 1);
    EXPECT_EQ(run.value("bites_done"), 3);
    EXPECT_EQ(run.value("torn_volume_mm3"), 0);
    EXPECT_EQ(run.value("over_force_count"), 0);
    EXPECT_GT(run.value("slit_burst_cmh2o"), 6);
    // Content with 90 mN where the expert draws until 120: it holds less.
    EXPECT_LT(run.value("slit_burst_cmh2o"), 0.6 * expert().value("slit_burst_cmh2o"));
    // It says where: of the recording alone.
    const auto map = assessment::leak_map(run.recording);
    ASSERT_TRUE(map && map->whole && map->burst);
    EXPECT_EQ(map->bites.size(), 3U);
    const auto burst = assessment::worst_leak(*map, assessment::LeakStage::kLast);
    ASSERT_TRUE(burst && burst->between.any());
    EXPECT_NEAR(1e3 * burst->along_m, run.value("slit_burst_mm"), 1e-9);
    EXPECT_NEAR((burst->leak_m3_s + burst->rest_m3_s) / map->all_m3_s[2], 1, 1e-4);
    EXPECT_NEAR(run.value("draw_pull_least_mn"), 90, 8);
    EXPECT_GE(expert().value("draw_pull_least_mn"), 120);
    EXPECT_LT(run.score.points, expert().score.points - 5);
}

TEST(SutureSlit, WhoDoesNothingLeavesItOpen) {
    Task task = load_task("suture_slit");
    task.time_limit_s = 0.5;
    const Outcome outcome = judged(task, test::recorded(task, 1, test::scripted("expert")));
    EXPECT_EQ(outcome.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(outcome.score.points, 0);
    EXPECT_NEAR(outcome.value("slit_gap_widest_mm"), 0.95, 0.03);
    // Fluid rubs on the walls, and presses them apart.
    EXPECT_NEAR(outcome.value("slit_leak_6_ml_min"), open_leak_ml_min(), 0.06 * open_leak_ml_min());
    EXPECT_EQ(outcome.value("slit_burst_cmh2o"), 0);
    // An ellipse is widest, and so leaks and bursts most, in its middle.
    EXPECT_NEAR(outcome.value("slit_leak_worst_mm"), 6, 1);
    EXPECT_NEAR(outcome.value("slit_burst_mm"), 6, 1);
    EXPECT_EQ(outcome.value("slit_leak_worst_stretch"), 0);
}

TEST(SutureSlit, IsReplayedBitForBitOnOtherNumbersOfThreadsAndItsWallsNeverPassEachOther) {
    Replay replay(expert().recording, 2);
    const sim::Scene& scene = replay.scene();
    double deepest = 0;
    while (replay.step()) {
        const sim::State& state = replay.state();
        if (state.frame % 20 != 0) continue;
        for (const sim::Slit::Station& s : scene.slit.stations) {
            for (size_t level = 0; level < 2; ++level) {
                // Along +y: the left wall lies at smaller x.
                const double apart = (sim::position(state.body, s.right[level]) -
                                      sim::position(state.body, s.left[level]))
                                         .x();
                deepest = std::max(deepest, -apart);
            }
        }
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
    EXPECT_EQ(replay.result().frames, std::ssize(expert().recording.inputs));
    // Drawn tight, the thread lies on the skin between two bites, and does not sink into it.
    sim::Snapshot seen;
    sim::fill_snapshot(scene, replay.state(), seen);
    int bridges = 0;
    for (const double path_m : seen_stretches_m(seen)) bridges += path_m > 4e-3 ? 1 : 0;
    EXPECT_GE(bridges, 3) << "from the needle to the last bite, and between three bites";
    EXPECT_EQ(seen.needle.loop.size(), 17U) << "its loop lies on the first";
    EXPECT_EQ(seen.slit, 1);
    EXPECT_LT(deepest, 1e-4);
    RecordProperty("deepest_um", std::to_string(1e6 * deepest));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum

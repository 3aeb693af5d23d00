// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/metric_groups.h"

#include <gtest/gtest.h>

#include <map>

#include "report_fixture.h"

using namespace placode;

namespace THIS_TEST {

using namespace placode::test;

TEST(MetricGroups, EveryMetricHasAGroupThatItsNameFits) {
    using reports::MetricGroup;
    std::map<MetricGroup, int> counts;
    for (const auto& each : assessment::metric_definitions())
        ++counts[reports::group_of_metric(each.id)];
    EXPECT_EQ(counts.size(), 12u) << "an empty group";
    // What begins like nothing else is motion: it stays the only large one.
    for (const auto& [group, count] : counts) EXPECT_LE(count, 25) << reports::group_title(group);
    EXPECT_EQ(reports::group_of_metric("placode_impulse_mn_s"), MetricGroup::kPlacode);
    EXPECT_EQ(reports::group_of_metric("path_length_left_mm"), MetricGroup::kHands);
    EXPECT_EQ(reports::group_of_metric("path_length_mm"), MetricGroup::kMotion);
}

TEST(MetricGroups, WhatTheScoreLooksAtIsNeverLeftOut) {
    sim::RecordingHeader header;
    header.tools.resize(1);
    header.tools[0].kind = sim::ToolKind::kGrasper;
    const assessment::MetricSet metrics = attempt().metrics;
    const auto has = [&](const std::vector<std::string>& scored, const char* id) {
        for (const auto& group :
             reports::grouped_metrics(metrics, reports::scope_of(header.tools, scored)))
            for (const auto& each : group.metrics)
                if (each.id == id) return true;
        return false;
    };
    EXPECT_FALSE(has({}, "energy_on_s")) << "a grasper has no energy";
    EXPECT_TRUE(has({"energy_on_s"}, "energy_on_s"));
    EXPECT_TRUE(has({}, "grasps"));
}

TEST(MetricGroups, ATaskWithoutARingHasNoRingNumbers) {
    sim::RecordingHeader header = recording().header;
    const assessment::MetricSet metrics = attempt().metrics;
    const auto has = [&](const std::vector<std::string>& scored, const assessment::MetricSet& of,
                         const char* id) {
        for (const auto& group :
             reports::grouped_metrics(of, reports::scope_of(header.tools, scored)))
            for (const auto& each : group.metrics)
                if (each.id == id) return true;
        return false;
    };
    EXPECT_FALSE(has({"steps_done_percent"}, metrics, "ring_completeness_percent"));
    EXPECT_TRUE(has({"outside_band_mm"}, metrics, "ring_completeness_percent"));
    EXPECT_TRUE(has({}, metrics, "ring_completeness_percent")) << "nobody knows the task any more";
    // Two names for nearly the same, and counts that are 0 because every hand was calm.
    header.tools[1].kind = sim::ToolKind::kGrasper;
    EXPECT_TRUE(has({}, metrics, "idle_percent"));
    EXPECT_FALSE(has({}, metrics, "neither_moving_percent"));
    EXPECT_TRUE(has({"neither_moving_percent"}, metrics, "neither_moving_percent"));
    EXPECT_TRUE(has({}, metrics, "movements"));
    assessment::MetricSet calm;
    calm.values = {{"path_length_mm", 125}, {"movements", 0}, {"speed_peaks_per_min", 0}};
    EXPECT_FALSE(has({}, calm, "movements"));
    EXPECT_FALSE(has({}, calm, "speed_peaks_per_min"));
    EXPECT_TRUE(has({"movements"}, calm, "movements"));
    EXPECT_TRUE(reports::nothing_moved_fast(calm));
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the last events say of how a patch lies.
#include "assessment/patch_metrics.h"

#include <gtest/gtest.h>

#include "assessment/loci.h"

namespace placode::assessment {
namespace THIS_TEST {

sim::Event patch_event(sim::EventKind kind, int element, double value, double value2) {
    sim::Event event;
    event.time_s = 40;
    event.kind = kind;
    event.element = element;
    event.value = static_cast<float>(value);
    event.value2 = static_cast<float>(value2);
    event.rest_position_m = {0.003F, 0.0001F * static_cast<float>(element + 1), 0};
    return event;
}
sim::Event edge(int point, double overlap_m, double open = 0) {
    return patch_event(sim::EventKind::kPatchEdge, point, overlap_m, open);
}
sim::Event grasp(sim::Tissue tissue, int tet) {
    sim::Event event = patch_event(sim::EventKind::kGrasped, tet, 3, 0.1);
    event.time_s = 3;
    event.tissue = tissue;
    return event;
}

sim::Recording laid() {
    sim::Recording recording;
    recording.events = {grasp(sim::Tissue::kDura, -1),
                        edge(-1, 4, 0.125),
                        edge(0, 0.006),
                        edge(1, 0.005),
                        edge(2, 0.002),
                        edge(3, 0),
                        patch_event(sim::EventKind::kPatchFold, -1, 30e-6, 300e-6)};
    return recording;
}

MetricSet metrics_of_patch(const sim::Recording& recording) {
    MetricSet set;
    add_patch_metrics(recording, set.values);
    return set;
}

TEST(PatchMetrics, SayShareMeanLeastOpenAndFolds) {
    const MetricSet set = metrics_of_patch(laid());
    EXPECT_DOUBLE_EQ(*set.find("patch_overlap_percent"), 50) << "5 mm in a float count as 5 mm";
    EXPECT_NEAR(*set.find("patch_overlap_mean_mm"), 3, 1e-6) << "6 mm count as 5";
    EXPECT_EQ(*set.find("patch_overlap_least_mm"), 0);
    EXPECT_DOUBLE_EQ(*set.find("patch_uncovered_percent"), 12.5);
    EXPECT_NEAR(*set.find("patch_folded_percent"), 10, 1e-5);
    EXPECT_EQ(*set.find("patch_grasps"), 1);
    EXPECT_NEAR(locate("patch_overlap_least_mm", 5, laid()).at_m->y(), 0.0004, 1e-8);
    EXPECT_NEAR(locate("patch_uncovered_percent", 0, laid()).at_m->y(), 0.0004, 1e-8);
    EXPECT_TRUE(locate("patch_folded_percent", 1, laid()).at_m);
    EXPECT_EQ(locate("patch_grasps", 1, laid()).time_s, 3);
}

TEST(PatchMetrics, TissueTakenInsteadOfThePatchCountsAsAGrasp) {
    sim::Recording recording = laid();
    recording.events.push_back(grasp(sim::Tissue::kZone, 17));
    EXPECT_EQ(*metrics_of_patch(recording).find("patch_grasps"), 2);
}

/// An attempt that was broken off, or a file that lost events, says nothing: nobody gains by it.
TEST(PatchMetrics, WhatIsNotAllThereSaysNothing) {
    EXPECT_TRUE(metrics_of_patch({}).values.empty());
    for (size_t lost = 1; lost < laid().events.size(); ++lost) {
        sim::Recording recording = laid();
        recording.events.erase(recording.events.begin() + static_cast<std::ptrdiff_t>(lost));
        EXPECT_TRUE(metrics_of_patch(recording).values.empty()) << lost;
    }
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

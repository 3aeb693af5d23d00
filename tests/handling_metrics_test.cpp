// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics of a needle that goes from hand to hand, from events.
#include "assessment/handling_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/loci.h"

namespace placode::assessment {
namespace THIS_TEST {

using sim::EventKind;

sim::Recording recorded(int drivers) {
    sim::Recording recording;
    for (int i = 0; i < drivers; ++i) {
        sim::ToolSpec driver;
        driver.kind = sim::ToolKind::kNeedleDriver;
        recording.header.tools.push_back(driver);
    }
    return recording;
}

sim::Event& add(sim::Recording& recording, EventKind kind, double time_s, double value,
                double value2) {
    sim::Event event;
    event.kind = kind;
    event.time_s = time_s;
    event.value = static_cast<float>(value);
    event.value2 = static_cast<float>(value2);
    return recording.events.emplace_back(event);
}

TEST(HandlingMetrics, TheWorstOfEachAndTheSumOfTurns) {
    const auto degrees = [](double deg) { return deg * std::numbers::pi / 180; };
    sim::Recording recording = recorded(2);
    for (const double askew : {5.0, 30.0, 10.0})
        add(recording, EventKind::kNeedleGrip, askew, 0.4, std::cos(degrees(askew)));
    add(recording, EventKind::kNeedlePlaced, 1, 0, 0.02);
    add(recording, EventKind::kNeedlePlaced, 2, 1, 0.11);
    add(recording, EventKind::kNeedleHandedOver, 3, std::sin(degrees(6)), 0.2).element = 400;
    add(recording, EventKind::kNeedleHandedOver, 4, std::sin(degrees(2)), 0.5).element = 300;
    add(recording, EventKind::kNeedleHandedOver, 5, 0, 0).element = 0;
    add(recording, EventKind::kNeedleDropped, 6, 2, 0.01);
    add(recording, EventKind::kNeedleSwung, 7, degrees(90), 0);
    add(recording, EventKind::kNeedleSwung, 8, degrees(30), 0);
    const MetricSet set = compute_metrics(recording);
    EXPECT_EQ(set.find("needle_handovers"), 2);
    EXPECT_EQ(set.find("needle_let_between"), 1);
    EXPECT_EQ(set.find("needle_drops"), 1);
    EXPECT_NEAR(*set.find("needle_askew_deg"), 30, 1e-4);
    EXPECT_NEAR(*set.find("needle_place_off_percent"), 11, 1e-4);
    EXPECT_NEAR(*set.find("needle_handover_turn_deg"), 12, 1e-4);
    EXPECT_NEAR(*set.find("needle_handover_force_mn"), 500, 1e-3);
    EXPECT_NEAR(*set.find("needle_turned_deg"), 120, 1e-4);
    // Where each can be seen.
    EXPECT_EQ(locate("needle_askew_deg", 0, recording).time_s, 30);
    EXPECT_EQ(locate("needle_handover_turn_deg", 0, recording).time_s, 3);
    EXPECT_EQ(locate("needle_handover_force_mn", 0, recording).time_s, 4);
    EXPECT_EQ(locate("needle_let_between", 0, recording).time_s, 5);
    EXPECT_EQ(locate("needle_drops", 0, recording).time_s, 6);
}

// Both held it and the first one kept it, or the attempt ended: no hand-over, but no less force.
TEST(HandlingMetrics, WhatBothHandsDidCountsWhoeverLetsGo) {
    sim::Recording recording = recorded(2);
    add(recording, EventKind::kNeedleHandedOver, 3, 0.1, 0.2).element = 400;
    add(recording, EventKind::kNeedleHandedOver, 5, 0.5, 0.7).element = -1;
    const MetricSet set = compute_metrics(recording);
    EXPECT_EQ(set.find("needle_handovers"), 1);
    EXPECT_EQ(set.find("needle_let_between"), 0);
    EXPECT_NEAR(*set.find("needle_handover_turn_deg"), 60, 1e-4);
    EXPECT_NEAR(*set.find("needle_handover_force_mn"), 700, 1e-3);
    EXPECT_EQ(locate("needle_handovers", 2, recording).count, 1);
    EXPECT_EQ(locate("needle_let_between", 0, recording).count, 0);
}

TEST(HandlingMetrics, NothingHappenedIsNothingBad) {
    const MetricSet set = compute_metrics(recorded(2));
    for (const char* id : {"needle_handovers", "needle_drops", "needle_askew_deg",
                           "needle_handover_force_mn", "needle_turned_deg"})
        EXPECT_EQ(set.find(id), 0) << id;
}

TEST(HandlingMetrics, OneDriverHandsNothingOver) {
    sim::Recording recording = recorded(1);
    add(recording, EventKind::kNeedleTaken, 1, 0.01, 0.6);
    const MetricSet set = compute_metrics(recording);
    EXPECT_FALSE(set.find("needle_handovers"));
    EXPECT_FALSE(set.find("needle_drops"));
    EXPECT_TRUE(set.find("needle_regrasps"));
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

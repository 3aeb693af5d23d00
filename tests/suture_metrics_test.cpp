// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/suture_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/loci.h"

namespace placode::assessment {
namespace THIS_TEST {

using sim::EventKind;

sim::Recording with_driver() {
    sim::Recording recording;
    recording.header.tools.resize(1);
    recording.header.tools[0].kind = sim::ToolKind::kNeedleDriver;
    return recording;
}
void add(sim::Recording& recording, EventKind kind, float value = 0, float value2 = 0) {
    sim::Event event;
    event.kind = kind;
    event.value = value;
    event.value2 = value2;
    recording.events.push_back(event);
}
MetricSet measured(const sim::Recording& recording) {
    MetricSet set;
    add_suture_metrics(recording, set.values);
    return set;
}

TEST(SutureMetrics, TheLastBiteCountsAndTroublesAreCounted) {
    sim::Recording recording = with_driver();
    add(recording, EventKind::kNeedleTaken);
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.3F);
    add(recording, EventKind::kBiteEntry, 0, 2e-3F);
    add(recording, EventKind::kNeedleWithdrawn);
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.5F);
    add(recording, EventKind::kBiteEntry, 0, 0.25e-3F);
    add(recording, EventKind::kNeedleLeft, 0.024F, 1.25e-3F);
    add(recording, EventKind::kBiteExit, 1, 0.75e-3F);
    add(recording, EventKind::kNeedleReleased);
    add(recording, EventKind::kNeedleTaken);
    add(recording, EventKind::kNeedleSlipped, 0.1F);
    add(recording, EventKind::kNeedleTurned, 0.1F);
    add(recording, EventKind::kThreadCut, 700);
    const MetricSet set = measured(recording);
    EXPECT_NEAR(*set.find("bite_entry_offset_mm"), 0.25, 1e-6);
    EXPECT_NEAR(*set.find("bite_exit_offset_mm"), 0.75, 1e-6);
    EXPECT_NEAR(*set.find("bite_depth_mm"), 1.25, 1e-6);
    EXPECT_NEAR(*set.find("bite_angle_deg"), 30, 1e-4) << "of a sine of a half";
    EXPECT_EQ(*set.find("needle_entries"), 2);
    EXPECT_EQ(*set.find("needle_regrasps"), 1);
    EXPECT_EQ(*set.find("needle_slips"), 2);
    EXPECT_EQ(*set.find("thread_cuts"), 1);
    // A reason says as many times as the metric counts.
    add(recording, EventKind::kThreadToreOut, 700);
    for (const char* id : {"needle_entries", "needle_regrasps", "needle_slips", "thread_cuts"})
        EXPECT_EQ(locate(id, 0, recording).count, *measured(recording).find(id)) << id;
}

TEST(SutureMetrics, ABiteIsDoneWhenTheNeedleIsThroughIt) {
    sim::Recording recording = with_driver();
    const auto told = [&](EventKind kind, uint64_t channel) {
        add(recording, kind);
        recording.events.back().hash = channel;
        return measured(recording).find("bites_done");
    };
    EXPECT_FALSE(told(EventKind::kNeedleEntered, 1)) << "not yet a bite of the task";
    EXPECT_EQ(told(EventKind::kBiteEntry, 0), 0);
    EXPECT_EQ(told(EventKind::kNeedleLeft, 1), 0);
    EXPECT_EQ(told(EventKind::kBiteExit, 0), 0);
    // Drawn back, and run through elsewhere.
    EXPECT_EQ(told(EventKind::kNeedleWithdrawn, 1), 0);
    EXPECT_EQ(told(EventKind::kNeedleEntered, 2), 0);
    EXPECT_EQ(told(EventKind::kNeedleLeft, 2), 0);
    EXPECT_EQ(told(EventKind::kNeedleThrough, 2), 0);
    EXPECT_EQ(told(EventKind::kNeedleThrough, 1), 1);
    EXPECT_EQ(told(EventKind::kThreadCut, 1), 1);
    EXPECT_EQ(told(EventKind::kThreadToreOut, 2), 1);
    EXPECT_EQ(told(EventKind::kThreadToreOut, 1), 0) << "it holds nothing any more";
}

// Else a steep and deep prick anywhere would stand for a bite that is flat and shallow.
TEST(SutureMetrics, APrickBesideTheBiteSaysNothingOfIt) {
    sim::Recording recording = with_driver();
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.9F);
    add(recording, EventKind::kNeedleLeft, 0.024F, 1.5e-3F);
    EXPECT_FALSE(measured(recording).find("bite_angle_deg").has_value()) << "no bite of the task";
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.1F);
    add(recording, EventKind::kBiteEntry, 0, 0);
    EXPECT_FALSE(measured(recording).find("bite_depth_mm").has_value()) << "it is still in it";
    add(recording, EventKind::kNeedleLeft, 0.024F, 0.2e-3F);
    add(recording, EventKind::kBiteExit, 1, 0);
    const MetricSet bite = measured(recording);
    EXPECT_NEAR(*bite.find("bite_depth_mm"), 0.2, 1e-6);
    EXPECT_NEAR(*bite.find("bite_angle_deg"), std::asin(0.1) * 180 / std::numbers::pi, 1e-4);
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.9F);
    add(recording, EventKind::kNeedleLeft, 0.024F, 1.5e-3F);
    for (const char* id : {"bite_depth_mm", "bite_angle_deg"})
        EXPECT_EQ(measured(recording).find(id), bite.find(id)) << id;
    EXPECT_EQ(*measured(recording).find("needle_entries"), 3);
    // The next one begins anew.
    add(recording, EventKind::kBiteEntry, 5, 0);
    add(recording, EventKind::kNeedleLeft, 0.024F, 1.1e-3F);
    add(recording, EventKind::kBiteExit, 6, 0);
    EXPECT_NEAR(*measured(recording).find("bite_angle_deg"),
                std::asin(0.9) * 180 / std::numbers::pi, 1e-4);
}

TEST(SutureMetrics, WhatWasNotDoneHasNoValueAndNoDriverNoMetric) {
    sim::Recording recording = with_driver();
    add(recording, EventKind::kNeedleTaken);
    const MetricSet set = measured(recording);
    EXPECT_FALSE(set.find("bite_entry_offset_mm").has_value());
    EXPECT_FALSE(set.find("bite_depth_mm").has_value());
    EXPECT_EQ(*set.find("needle_entries"), 0);
    EXPECT_EQ(*set.find("needle_regrasps"), 0);
    recording.header.tools[0].kind = sim::ToolKind::kGrasper;
    add(recording, EventKind::kNeedleEntered, 0.025F, 0.3F);
    EXPECT_TRUE(measured(recording).values.empty());
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

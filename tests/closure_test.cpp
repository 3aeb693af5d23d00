// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the events of a slit say about how it was sewn up.
#include "assessment/closure.h"

#include <gtest/gtest.h>

#include "assessment/loci.h"

namespace placode::assessment {
namespace THIS_TEST {

sim::Event station(int number, double gap_m, double y_m) {
    sim::Event event;
    event.time_s = 30;
    event.kind = sim::EventKind::kSlitGap;
    event.element = number;
    event.value = static_cast<float>(number < 0 ? 3 : gap_m);
    event.rest_position_m = {0.009F, static_cast<float>(y_m), 0};
    return event;
}

TEST(Closure, MeanAndWidestGapOfAllStations) {
    sim::Recording recording;
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_TRUE(set.values.empty()) << "no slit, no number";
    recording.events = {station(-1, 0, 0), station(0, 0, -0.004), station(1, 0.0006, 0.001),
                        station(2, 0.0003, 0.004)};
    add_closure_metrics(recording, set.values);
    EXPECT_NEAR(*set.find("slit_shut_percent"), 100.0 / 3, 1e-6);
    EXPECT_NEAR(*set.find("slit_gap_mean_mm"), 0.3, 1e-6);
    EXPECT_NEAR(*set.find("slit_gap_widest_mm"), 0.6, 1e-6);
    const Locus widest = locate("slit_gap_widest_mm", 0.2, recording);
    ASSERT_TRUE(widest.at_m);
    EXPECT_NEAR(widest.at_m->y(), 0.001, 1e-7);
}

TEST(Closure, ASlitThatIsShutHasNoGap) {
    sim::Recording recording;
    recording.events = {station(-1, 0, 0), station(0, 0, -0.004), station(1, 0, 0.001)};
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_EQ(*set.find("slit_gap_mean_mm"), 0);
    EXPECT_EQ(*set.find("slit_gap_widest_mm"), 0);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

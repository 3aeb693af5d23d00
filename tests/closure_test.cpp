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

TEST(Closure, TheLeakOfOneStitchIsThatOfTheTable) {
    // 3 mm wide, 1.5 mm deep, 6 cmH2O: viscous alone 1.05 ml/min at 0.05 mm, orifice alone 58 at
    // 0.5 mm; in series a little less.
    const auto ml_min = [](double gap_m) { return 6e7 * leak_m3_s({3e-3, gap_m, gap_m, 1.5e-3}); };
    EXPECT_NEAR(ml_min(0.05e-3), 1.05, 0.05);
    EXPECT_NEAR(ml_min(0.5e-3), 58, 3);
    EXPECT_EQ(ml_min(0), 0);
    EXPECT_GT(ml_min(1e-9), 0);
    // A thousand times finer: the cube of it.
    EXPECT_NEAR(ml_min(1e-8) / ml_min(1e-7), 1e-3, 1e-8);
}

TEST(Closure, PressureOfTheLeakIsLostInSlitAndNeck) {
    const LeakyGap gap{2e-3, 0.3e-3, 0.1e-3, 0.8e-3};
    const double q = leak_m3_s(gap);
    // The resistance of the taper by the midpoint rule.
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        const double g = gap.mouth_m + (gap.neck_m - gap.mouth_m) * (i + 0.5) / kSteps;
        sum += gap.depth_m / kSteps / (g * g * g);
    }
    const double viscous_pa = 12 * 0.7e-3 * sum * q / gap.length_m;
    const double speed = q / (0.6 * gap.length_m * gap.neck_m);
    EXPECT_NEAR(viscous_pa + 0.5 * 1005 * speed * speed, kLeakPa, 1e-3);
    for (const LeakyGap& more :
         {LeakyGap{2e-3, 0.31e-3, 0.1e-3, 0.8e-3}, LeakyGap{2e-3, 0.3e-3, 0.11e-3, 0.8e-3},
          LeakyGap{2.1e-3, 0.3e-3, 0.1e-3, 0.8e-3}, LeakyGap{2e-3, 0.3e-3, 0.1e-3, 0.7e-3}})
        EXPECT_GT(leak_m3_s(more), q);
}

TEST(Closure, ALeakIsTheSumAlongTheSlitAndUnknownWithoutItsDepth) {
    sim::Recording recording;
    recording.events = {station(-1, 0, 0), station(0, 0, -0.002), station(1, 0.0002, 0),
                        station(2, 0.0004, 0.001)};
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_FALSE(set.find("slit_leak_ml_min"));
    recording.events[0].value2 = 0.8e-3F;
    for (size_t i = 1; i < 4; ++i) recording.events[i].value2 = recording.events[i].value;
    set.values.clear();
    add_closure_metrics(recording, set.values);
    const double expected =
        leak_m3_s({1.5e-3, 0.0002, 0.0002, 0.8e-3}) + leak_m3_s({0.5e-3, 0.0004, 0.0004, 0.8e-3});
    EXPECT_NEAR(*set.find("slit_leak_ml_min") / (6e7 * expected), 1, 1e-5);
}

sim::Event pressed(int element, double flow_m3_s, double pressure_pa) {
    sim::Event event;
    event.kind = sim::EventKind::kWatertight;
    event.element = element;
    event.value = static_cast<float>(flow_m3_s);
    event.value2 = static_cast<float>(pressure_pa);
    event.rest_position_m = {0.009F, 0.001F * static_cast<float>(element), 0};
    return event;
}

TEST(Closure, UnderPressureTheMeasuredLeakTakesThePlaceOfTheCalculatedOne) {
    sim::Recording recording;
    recording.events = {station(-1, 0, 0), station(0, 0.0001, -0.004), station(1, 0.0002, 0.001)};
    recording.events[0].value2 = 0.8e-3F;
    for (size_t i = 1; i < 3; ++i) recording.events[i].value2 = recording.events[i].value;
    const std::vector<sim::Event> test{pressed(-1, 5e-8, 588.4),  pressed(0, 1e-8, 588.4),
                                       pressed(1, 4e-8, 588.4),   pressed(-1, 2e-7, 1225.8),
                                       pressed(0, 19e-8, 1225.8), pressed(1, 1e-8, 1225.8),
                                       pressed(-2, 1.7e-7, 1000)};
    recording.events.insert(recording.events.end(), test.begin(), test.end());
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_NEAR(*set.find("slit_leak_6_ml_min"), 3, 1e-5);
    EXPECT_NEAR(*set.find("slit_leak_12_ml_min"), 12, 1e-5);
    // 1,000 Pa are 10.197 cmH2O, rounded down.
    EXPECT_NEAR(*set.find("slit_burst_cmh2o"), 10.1, 1e-9);
    EXPECT_FALSE(set.find("slit_leak_ml_min"));
    // A reason shows the station that leaks most at the lower pressure.
    EXPECT_NEAR(locate("slit_burst_cmh2o", 12.5, recording).at_m->y(), 0.001, 1e-7);
    EXPECT_NEAR(locate("slit_gap_widest_mm", 0.2, recording).at_m->y(), 0.001, 1e-7);
    // Broken off in the middle it says nothing.
    recording.events.pop_back();
    set.values.clear();
    add_closure_metrics(recording, set.values);
    EXPECT_FALSE(set.find("slit_burst_cmh2o"));
    EXPECT_TRUE(set.find("slit_leak_ml_min"));
}

TEST(Closure, ASlitThatIsShutHasNoGap) {
    sim::Recording recording;
    recording.events = {station(-1, 0, 0), station(0, 0, -0.004), station(1, 0, 0.001)};
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_EQ(*set.find("slit_gap_mean_mm"), 0);
    EXPECT_EQ(*set.find("slit_gap_widest_mm"), 0);
    recording.events[0].value2 = 0.8e-3F;
    set.values.clear();
    add_closure_metrics(recording, set.values);
    EXPECT_EQ(*set.find("slit_leak_ml_min"), 0);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

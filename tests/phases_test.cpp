// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/phases.h"

#include <gtest/gtest.h>

namespace placode::assessment {
namespace THIS_TEST {

using sim::EventKind;
using sim::Phase;

sim::Event event(double time_s, EventKind kind, float value = 0) {
    sim::Event e;
    e.time_s = time_s;
    e.kind = kind;
    e.value = value;
    return e;
}

/// Looks for 2 s, cuts for 3 s and moves by 30 mm in it, checks for 1 s, cuts again for 1 s.
sim::Recording attempt() {
    sim::Recording recording;
    recording.header.sample_s = 0.01;
    recording.header.tools.resize(1);
    for (int k = 0; k < 700; ++k) {
        sim::Sample sample;
        sample.time_s = 0.01 * k;
        const double t = sample.time_s;
        sample.phase = t < 2   ? Phase::kInspect
                       : t < 5 ? Phase::kIncise
                       : t < 6 ? Phase::kCheck
                               : Phase::kIncise;
        sample.tools[0].tip_m[0] = t < 2 ? 0 : static_cast<float>(0.01 * (std::min(t, 5.0) - 2));
        recording.samples.push_back(sample);
    }
    recording.events = {event(0.5, EventKind::kOverForce, 0.2F),
                        event(2.0, EventKind::kPhase, static_cast<float>(Phase::kIncise)),
                        event(3.0, EventKind::kOverForce, 0.3F),
                        event(3.5, EventKind::kOverForce, 0.4F),
                        event(3.6, EventKind::kStateHash),
                        event(5.0, EventKind::kPhase, static_cast<float>(Phase::kCheck)),
                        event(6.0, EventKind::kPhase, static_cast<float>(Phase::kIncise)),
                        event(6.995, EventKind::kDwell, 2)};
    recording.end.duration_s = 7;
    return recording;
}

TEST(Phases, EveryPartHasMetricsOfItsOwn) {
    const auto parts = compute_phase_metrics(attempt());
    ASSERT_EQ(parts.size(), 4u);
    EXPECT_EQ(parts[1].phase, Phase::kIncise);
    EXPECT_NEAR(parts[1].from_s, 2, 1e-9);
    EXPECT_NEAR(parts[1].to_s, 4.99, 1e-9);
    EXPECT_NEAR(*parts[0].metrics.find("path_length_mm"), 0, 1e-9);
    EXPECT_NEAR(*parts[1].metrics.find("path_length_mm"), 29.9, 0.05) << "299 steps of 0.1 mm";
    EXPECT_NEAR(*parts[1].metrics.find("task_time_s"), 2.99, 1e-9);
    EXPECT_NEAR(*parts[0].metrics.find("over_force_count"), 1.1, 1e-6);
    EXPECT_NEAR(*parts[1].metrics.find("over_force_count"), 1.15 + 0.1 / 3 + 0.2, 1e-6);
    EXPECT_EQ(*parts[2].metrics.find("over_force_count"), 0);
    EXPECT_EQ(*parts[3].metrics.find("dwell_s"), 2) << "after the last sample, before the end";
    double sum = 0;
    for (const auto& part : parts) sum += *part.metrics.find("over_force_s");
    EXPECT_NEAR(sum, *compute_metrics(attempt()).find("over_force_s"), 1e-9) << "none is lost";
}

TEST(Phases, NothingRecordedHasNoParts) { EXPECT_TRUE(compute_phase_metrics({}).empty()); }

}  // namespace THIS_TEST
}  // namespace placode::assessment

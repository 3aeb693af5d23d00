// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blood vessels by space colonisation: a seeded tree grows towards attraction points; radii follow
// Murray's law. Source: Runions et al. 2005, "Modeling and visualization of leaf venation
// patterns".

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::view {

struct VesselSegment {
    sim::Vec2 a = sim::Vec2::Zero(), b = sim::Vec2::Zero();  ///< [mm]
    double radius_a = 0, radius_b = 0;                       ///< [mm]
};

struct VesselSpec {
    std::vector<sim::Vec2> roots;                                 ///< Where trees start [mm].
    std::function<bool(const sim::Vec2&)> inside;                 ///< Where they may grow.
    sim::Vec2 low = sim::Vec2::Zero(), high = sim::Vec2::Zero();  ///< Box that holds `inside` [mm].
    int attractors = 500;
    double step_mm = 0.3, kill_mm = 0.55, reach_mm = 6;
    double thinnest_mm = 0.012, murray = 2.6;
    double wander = 0.35;  ///< Random share of every growth step.
    uint64_t seed = 1;
};

/// In [0, 1). std::uniform_real_distribution differs between libraries; this does not.
[[nodiscard]] inline double unit(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

[[nodiscard]] std::vector<VesselSegment> grow_vessels(const VesselSpec& spec);

}  // namespace placode::view

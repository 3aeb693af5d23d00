// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rods for tests: along a curve, and run until they rest.

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/as_index.h"
#include "sim/rod/rod_step.h"

namespace placode::test {

using sim::as_index;
using sim::Quat;
using sim::Rod;
using sim::RodDrive;
using sim::RodScratch;
using sim::RodSpec;
using sim::RodState;
using sim::Vec3;

inline constexpr double kPi = std::numbers::pi;

/// Weight of the thread per length for 1 m/s^2 [kg/m].
inline double mass_per_m(const RodSpec& spec) {
    return spec.density_kg_m3 * kPi * spec.radius_m * spec.radius_m;
}

/// Nodes at `place(s)` for s = 0 .. 1 in equal steps.
template <class Place>
std::vector<Vec3> along(const Rod& rod, Place&& place) {
    std::vector<Vec3> out;
    for (int i = 0; i < rod.nodes(); ++i)
        out.push_back(place(static_cast<double>(i) / rod.segments()));
    return out;
}
inline std::vector<Vec3> straight(const Rod& rod, const Vec3& direction = Vec3::UnitX()) {
    return along(rod, [&](double s) { return Vec3(s * rod.spec().length_m * direction); });
}

/// Steps until nothing moves faster than `speed_m_s`; false after `most` substeps.
inline bool settle(const Rod& rod, RodState& state, const RodDrive& drive, double speed_m_s,
                   int most = 20000) {
    RodScratch scratch(rod);
    for (int i = 0; i < most; ++i) {
        step_rod(rod, state, drive, scratch);
        double fastest = 0;
        for (const Vec3& v : state.v) fastest = std::max(fastest, v.norm());
        if (i > 20 && fastest < speed_m_s) return true;
    }
    return false;
}

}  // namespace placode::test

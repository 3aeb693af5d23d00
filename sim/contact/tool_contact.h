// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Instruments against each other: steel does not give way, the hands do. After the instruments have
// moved, two that overlap are moved apart along the line between the nearest points of their axes,
// each by the share that its hand yields (ToolSpec::hand_n_m). Without friction.
//
// The side on which they first met is remembered: hands that cross in the air do not carry the
// shafts through each other. Instruments whose hands are farther through than kLetGoM are let pass,
// as after a device was lost. The scope is left out: what moves it is a camera hand that nobody
// feels, and a picture that jumps teaches nothing.

#include <span>

#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;
struct ToolShape;

inline constexpr double kLetGoM = 6e-3;  ///< Deepest overlap of two shafts [m].

/// Where two instruments come nearest to each other.
struct ToolGap {
    double value_m = 1;     ///< Signed distance [m]; of overlapping tapers an estimate.
    double reach_m = 0;     ///< Sum of the radii there [m].
    Vec3 n = Vec3::Zero();  ///< From the first axis to the second, unit; zero when they meet.
};
[[nodiscard]] ToolGap gap_between(const ToolShape& a, const Pose& X_WA, const ToolShape& b,
                                  const Pose& X_WB) noexcept;

/// Moves overlapping proxies apart, then both to where hands and tissue are in balance (no farther
/// than `longest_m` of either tool), and adds the force to ToolState::steel_n as a mean over the
/// substeps of the frame. `hands_m`: where the hands are after this substep.
void part_tools(const Scene& scene, State& state, std::span<const Vec3> hands_m,
                std::span<const double> longest_m) noexcept;

}  // namespace placode::sim

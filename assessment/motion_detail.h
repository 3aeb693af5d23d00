// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Motion measures beyond path and smoothness: rotation by axis, economy, jerk, peaks, actions.
// Units of lengths are the caller's.

#include <span>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/motion_metrics.h"
#include "assessment/signal.h"

namespace placode::assessment {

/// Sum of |rotation about the own shaft| (+z of T): the twist part of each step [rad].
/// Source: response orientation, Cotin et al. 2002.
[[nodiscard]] double roll_path(std::span<const Quat> orientations) noexcept;

struct PivotPaths {
    double pitch_rad = 0, yaw_rad = 0;
};
/// Sum of |change| of the shaft's direction about x and y of the first orientation.
[[nodiscard]] PivotPaths pivot_paths(std::span<const Quat> orientations) noexcept;

/// sqrt(T^5 / (2 PL^2) * integral |jerk|^2 dt), without a unit; 18.97 for a minimum-jerk movement,
/// independent of its length and duration. Central differences. Nothing without movement.
/// Source: Cotin et al. 2002, Chmarra et al. 2008.
[[nodiscard]] std::optional<double> normalised_jerk(std::span<const Vec3> velocity, double rate_hz);

/// Strict local maxima above `threshold`.
[[nodiscard]] int speed_peaks(std::span<const double> speed, double threshold) noexcept;

/// Times the speed goes above `threshold` after having been below it for `rest_s` or more, and
/// stays above for `rest_s` or more. Source: PerkTutor (50 mm/s or 50 deg/s, 0.2 s).
[[nodiscard]] int action_count(std::span<const double> speed, double dt_s, double threshold,
                               double rest_s = 0.2) noexcept;
inline constexpr double kActionMmS = 50, kActionDegS = 50;  ///< PerkTutor's thresholds.

/// Angle between successive orientations over dt (N - 1) [rad/s].
[[nodiscard]] std::vector<double> angular_speed(std::span<const Quat> orientations, double dt_s);

/// Edges of the box around the positions.
[[nodiscard]] Vec3 extent(std::span<const Vec3> positions) noexcept;

/// Appends what the recording allows. Never throws on odd data.
void add_motion_details(ToolTracks& tool_tracks, std::vector<Metric>& out);

}  // namespace placode::assessment

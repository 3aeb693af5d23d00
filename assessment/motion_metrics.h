// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Motion metrics as pure functions of single signals, and of a recording.
// Units cancel or follow the input: a speed in mm/s gives the same SPARC as one in m/s.

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/signal.h"

namespace placode::assessment {

/// Length of the polyline [unit of the positions].
[[nodiscard]] double path_length(std::span<const Vec3> positions) noexcept;
/// Distance travelled along the tool's own shaft (+z of T) [unit of the positions].
[[nodiscard]] double depth_path(std::span<const Vec3> positions,
                                std::span<const Quat> orientations) noexcept;
/// Total rotation, sum of the angles between successive orientations [rad].
[[nodiscard]] double angular_path(std::span<const Quat> orientations) noexcept;

/// Spectral arc length of a speed profile, -1 or less, 0 = smoothest; nothing without movement.
/// Zero padding to 16 times the next power of two is part of the definition.
/// Source: Balasubramanian et al. 2015, code siva82kb/SPARC (fc 10 Hz, amplitude threshold 0.05).
[[nodiscard]] std::optional<double> sparc(std::span<const double> speed, double rate_hz);
/// Log dimensionless jerk of a speed profile (N dt long, N-2 second differences). Same source.
[[nodiscard]] std::optional<double> ldlj_speed(std::span<const double> speed, double rate_hz);
/// The same with the vector velocity: well defined at constant speed as well.
/// Source: siva82kb/monalysa.
[[nodiscard]] std::optional<double> ldlj_vector(std::span<const Vec3> velocity, double rate_hz);

/// Movements: times the speed rises through `threshold` after it had been below half of it.
[[nodiscard]] int movement_count(std::span<const double> speed, double threshold) noexcept;
/// Sum of dt over samples 0..N-2 whose speed is below `threshold` [s].
[[nodiscard]] double idle_time(std::span<const double> speed, double dt_s,
                               double threshold) noexcept;
/// Smoothness is only defined for discrete movements: those above this speed, at least so long.
inline constexpr double kSegmentMmS = 5, kSegmentShortestS = 0.3;
/// [first, last) ranges with speed at or above `threshold` that last `shortest_s` or more.
[[nodiscard]] std::vector<std::pair<size_t, size_t>> movement_segments(
    std::span<const double> speed, double dt_s, double threshold, double shortest_s);

/// Filtered 100 Hz track of one tool of a recording.
[[nodiscard]] Track tool_track(const sim::Recording& recording, size_t tool);

/// Tracks of a recording's tools, each made when somebody first asks for it: filtering them is most
/// of what metrics of motion take. One thread.
class ToolTracks {
 public:
    /// `recording` must outlive it.
    explicit ToolTracks(const sim::Recording& recording) : recording_(recording) {}
    [[nodiscard]] const sim::Recording& recording() const noexcept { return recording_; }
    /// Empty where the tool was not recorded. @pre tool < sim::kMaxTools.
    [[nodiscard]] const Track& of(size_t tool);

 private:
    const sim::Recording& recording_;
    std::array<std::optional<Track>, sim::kMaxTools> tracks_;
};

/// When the first instrument came into view: time is counted from here [s].
[[nodiscard]] double task_start_s(const sim::Recording& recording);

/// Of these metrics those that need no filtered track: task_time_s, out_of_view_s.
void add_time_metrics(const sim::Recording& recording, std::vector<Metric>& out);
/// Appends what the recording allows. Never throws on odd data.
void add_motion_metrics(ToolTracks& tool_tracks, std::vector<Metric>& out);

}  // namespace placode::assessment

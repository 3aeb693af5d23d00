// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/motion_detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assessment/bimanual.h"
#include "assessment/motion_metrics.h"
#include "assessment/statistics.h"
#include "assessment/tremor.h"

namespace placode::assessment {

namespace {

constexpr double kPeakMmS = 20, kHandMovesMmS = 5;
constexpr double kDegrees = 180 / std::numbers::pi;

/// A tool in a hand, with its track.
struct Held {
    size_t tool = 0;
    sim::Hand hand = sim::Hand::kRight;
    const Track& track;
};

std::vector<Held> held_tools(ToolTracks& tool_tracks) {
    const sim::Recording& recording = tool_tracks.recording();
    std::vector<Held> held;
    for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
        if (recording.header.tools[i].kind == sim::ToolKind::kScope) continue;
        const Track& track = tool_tracks.of(i);
        if (!track.empty()) held.push_back({i, recording.header.tools[i].hand, track});
    }
    return held;
}

/// Of a hand: of its tools the one that moves, because the other one is parked.
template <class SpeedOf>
std::vector<double> hand_speed(const std::vector<Held>& held, sim::Hand hand, SpeedOf&& speed_of) {
    std::vector<double> speed;
    for (const Held& one : held) {
        if (one.hand != hand) continue;
        const std::vector<double> own = speed_of(one.track);
        if (speed.empty()) speed = own;
        for (size_t k = 0; k < std::min(speed.size(), own.size()); ++k)
            speed[k] = std::max(speed[k], own[k]);
    }
    return speed;
}

std::vector<double> tip_speed(const Track& track) { return track.speed_m_s; }
std::vector<double> turn_speed(const Track& track) {
    return angular_speed(track.orientation, track.dt_s);
}

void add_rotation(const std::vector<Held>& held, std::vector<Metric>& out) {
    double roll = 0, pitch = 0, yaw = 0;
    for (const Held& one : held) {
        roll += roll_path(one.track.orientation);
        const PivotPaths pivot = pivot_paths(one.track.orientation);
        pitch += pivot.pitch_rad;
        yaw += pivot.yaw_rad;
    }
    out.push_back({"roll_path_deg", roll * kDegrees});
    out.push_back({"pitch_path_deg", pitch * kDegrees});
    out.push_back({"yaw_path_deg", yaw * kDegrees});
}

void add_economy(const std::vector<Held>& held, std::vector<Metric>& out) {
    const Held* most = nullptr;
    double longest = 0, peaks = 0, duration_s = 0, straight = 0, moved = 0;
    std::vector<double> jerks;
    for (const Held& one : held) {
        const double path = path_length(one.track.position_m);
        if (path > longest) {
            longest = path;
            most = &one;
        }
        peaks += speed_peaks(one.track.speed_m_s, kPeakMmS * 1e-3);
        duration_s = std::max(duration_s,
                              one.track.dt_s * static_cast<double>(one.track.speed_m_s.size() - 1));
        const std::span<const Vec3> velocity = one.track.velocity_m_s;
        for (const auto& [first, last] : movement_segments(one.track.speed_m_s, one.track.dt_s,
                                                           kSegmentMmS * 1e-3, kSegmentShortestS)) {
            const auto places = std::span(one.track.position_m).subspan(first, last - first);
            straight += (places.back() - places.front()).norm();
            moved += path_length(places);
            if (const auto jerk =
                    normalised_jerk(velocity.subspan(first, last - first), 1 / one.track.dt_s))
                jerks.push_back(*jerk);
        }
    }
    if (most != nullptr) {
        const double volume = extent(most->track.position_m).prod();
        out.push_back({"economy_of_volume", std::cbrt(volume) / longest});
        out.push_back({"working_volume_mm3", volume * 1e9});
    }
    if (moved > 0) out.push_back({"economy_of_motion", straight / moved});
    if (duration_s > 0) out.push_back({"speed_peaks_per_min", peaks / duration_s * 60});
    if (!jerks.empty()) out.push_back({"jerk_normalised", median_of(jerks)});
}

void add_actions(const std::vector<Held>& held, std::vector<Metric>& out) {
    int moves = 0, turns = 0;
    for (const Held& one : held) {
        moves += action_count(one.track.speed_m_s, one.track.dt_s, kActionMmS * 1e-3);
        turns += action_count(turn_speed(one.track), one.track.dt_s, kActionDegS / kDegrees);
    }
    out.push_back({"translational_actions", static_cast<double>(moves)});
    out.push_back({"rotational_actions", static_cast<double>(turns)});
}

/// Correlation of the hands' rotations.
void add_turning_together(const std::vector<Held>& held, std::vector<Metric>& out) {
    std::vector<double> right = hand_speed(held, sim::Hand::kRight, turn_speed),
                        left = hand_speed(held, sim::Hand::kLeft, turn_speed);
    const size_t n = std::min(right.size(), left.size());
    if (n < 2) return;
    right.resize(n);
    left.resize(n);
    const Bimanual both = bimanual_dexterity(left, right, held.front().track.dt_s, 0);
    out.push_back({"bimanual_rotation_r", both.pearson_r});
}

void add_hands(const std::vector<Held>& held, std::vector<Metric>& out) {
    std::vector<double> right = hand_speed(held, sim::Hand::kRight, tip_speed),
                        left = hand_speed(held, sim::Hand::kLeft, tip_speed);
    const size_t n = std::min(right.size(), left.size());
    if (n < 2) return;
    right.resize(n);
    left.resize(n);
    const Bimanual both =
        bimanual_dexterity(left, right, held.front().track.dt_s, kHandMovesMmS * 1e-3);
    out.push_back({"path_length_left_mm", both.path_left * 1e3});
    out.push_back({"path_length_right_mm", both.path_right * 1e3});
    out.push_back({"bimanual_r", both.pearson_r});
    out.push_back({"bimanual_balance", both.balance});
    out.push_back({"both_moving_percent", both.both * 100});
    out.push_back({"left_only_percent", both.left_only * 100});
    out.push_back({"right_only_percent", both.right_only * 100});
    out.push_back({"neither_moving_percent", both.neither * 100});
}

/// Of unfiltered samples: the low pass would remove what is looked for.
void add_tremor(const sim::Recording& recording, const std::vector<Held>& held,
                std::vector<Metric>& out) {
    if (!(recording.header.sample_s > 0)) return;
    const double rate_hz = 1 / recording.header.sample_s;
    double worst = -1, worst_acceleration = -1;
    for (const Held& one : held) {
        std::vector<std::vector<double>> tip_mm(3);
        for (size_t axis = 0; axis < 3; ++axis) {
            tip_mm[axis].reserve(recording.samples.size());
            for (const sim::Sample& sample : recording.samples)
                tip_mm[axis].push_back(static_cast<double>(sample.tools[one.tool].tip_m[axis]) *
                                       1e3);
        }
        const std::optional<Tremor> tremor = tremor_of(tip_mm, rate_hz);
        if (!tremor) continue;
        worst = std::max(worst, tremor->power);
        worst_acceleration = std::max(worst_acceleration, tremor->acceleration_power);
    }
    if (worst < 0) return;
    out.push_back({"tremor_rms_mm", std::sqrt(worst)});
    out.push_back({"tremor_acceleration_mm_s2", std::sqrt(worst_acceleration)});
}

void add_view(const sim::Recording& recording, const std::vector<Held>& held,
              std::vector<Metric>& out) {
    int exits = 0;
    double hidden = 0;
    std::array<bool, sim::kMaxTools> seen{};
    for (const sim::Sample& sample : recording.samples)
        for (const Held& one : held) {
            const bool in_view = sample.tools[one.tool].in_view != 0;
            if (seen[one.tool] && !in_view) ++exits;
            seen[one.tool] = in_view;
            hidden += in_view ? 0 : 1;
        }
    const double all = static_cast<double>(recording.samples.size() * held.size());
    out.push_back({"out_of_view_count", static_cast<double>(exits)});
    out.push_back({"out_of_view_percent", 100 * hidden / all});
}

}  // namespace

double roll_path(std::span<const Quat> orientations) noexcept {
    double angle = 0;
    for (size_t k = 1; k < orientations.size(); ++k) {
        // The step in the tool's own frame; its twist about z is the part about the shaft.
        const Quat step = orientations[k - 1].conjugate() * orientations[k];
        angle += 2 * std::atan2(std::abs(step.z()), std::abs(step.w()));
    }
    return angle;
}

PivotPaths pivot_paths(std::span<const Quat> orientations) noexcept {
    PivotPaths sum;
    double pitch = 0, yaw = 0;
    for (size_t k = 1; k < orientations.size(); ++k) {
        const Vec3 shaft = orientations.front().conjugate() * (orientations[k] * Vec3::UnitZ());
        const double next_pitch = std::atan2(-shaft.y(), shaft.z()),
                     next_yaw = std::atan2(shaft.x(), shaft.z());
        sum.pitch_rad += std::abs(std::remainder(next_pitch - pitch, 2 * std::numbers::pi));
        sum.yaw_rad += std::abs(std::remainder(next_yaw - yaw, 2 * std::numbers::pi));
        pitch = next_pitch;
        yaw = next_yaw;
    }
    return sum;
}

std::optional<double> normalised_jerk(std::span<const Vec3> velocity, double rate_hz) {
    const size_t n = velocity.size();
    if (n < 5) return std::nullopt;
    const double dt = 1 / rate_hz, duration = static_cast<double>(n - 1) * dt;
    std::array<std::vector<double>, 3> jerk;
    for (size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> one(n);
        for (size_t k = 0; k < n; ++k) one[k] = velocity[k][static_cast<Eigen::Index>(axis)];
        jerk[axis] = derivative(derivative(one, dt), dt);
    }
    double path = 0, square = 0;
    for (size_t k = 1; k < n; ++k) {
        path += 0.5 * (velocity[k].norm() + velocity[k - 1].norm()) * dt;
        for (const auto& axis : jerk)
            square += 0.5 * (axis[k] * axis[k] + axis[k - 1] * axis[k - 1]) * dt;
    }
    if (!(path > 0)) return std::nullopt;
    const double value = std::sqrt(std::pow(duration, 5) / (2 * path * path) * square);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

int speed_peaks(std::span<const double> speed, double threshold) noexcept {
    int peaks = 0;
    for (size_t k = 1; k + 1 < speed.size(); ++k)
        if (speed[k] > threshold && speed[k] > speed[k - 1] && speed[k] > speed[k + 1]) ++peaks;
    return peaks;
}

int action_count(std::span<const double> speed, double dt_s, double threshold,
                 double rest_s) noexcept {
    int count = 0;
    bool moving = false;
    double other_s = 0;  // How long the opposite state has lasted.
    for (const double v : speed) {
        const bool above = v > threshold;
        other_s = above == moving ? 0 : other_s + dt_s;
        if (other_s <= rest_s) continue;
        moving = above;
        other_s = 0;
        if (moving) ++count;
    }
    return count;
}

std::vector<double> angular_speed(std::span<const Quat> orientations, double dt_s) {
    std::vector<double> speed;
    for (size_t k = 1; k < orientations.size(); ++k)
        speed.push_back(angular_path(orientations.subspan(k - 1, 2)) / dt_s);
    return speed;
}

Vec3 extent(std::span<const Vec3> positions) noexcept {
    if (positions.empty()) return Vec3::Zero();
    Vec3 low = positions.front(), high = low;
    for (const Vec3& p : positions) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return high - low;
}

void add_motion_details(ToolTracks& tool_tracks, std::vector<Metric>& out) {
    const sim::Recording& recording = tool_tracks.recording();
    if (recording.samples.empty()) return;
    const std::vector<Held> held = held_tools(tool_tracks);
    if (held.empty()) return;
    add_rotation(held, out);
    add_economy(held, out);
    add_actions(held, out);
    add_hands(held, out);
    add_turning_together(held, out);
    add_tremor(recording, held, out);
    add_view(recording, held, out);
}

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/signal_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assessment/bimanual.h"
#include "assessment/motion_detail.h"
#include "assessment/motion_metrics.h"
#include "assessment/tremor.h"
#include "sim/core/number_text.h"

namespace placode::assessment {

using Values = SignalValues;

double rate_of(const SignalFile& file, bool must_be_even) {
    const auto& time = file.values[0];
    const double mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (size_t i = 1; i < time.size(); ++i) {
        const double step = time[i] - time[i - 1];
        const std::string place = file.path + ":" + std::to_string(file.line(i)) + ": t_s";
        if (step <= 0)
            throw SignalError(place + ": found " + sim::shortest_text(time[i]) + " after " +
                              sim::shortest_text(time[i - 1]) + "; expected a time that grows");
        // 1 %: decimals cut off at 1/30 s stay far below it.
        if (must_be_even && std::abs(step - mean) > 0.01 * mean)
            throw SignalError(place + ": a step of " + sim::shortest_text(step) +
                              " s among steps of " + sim::shortest_text(mean) +
                              " s; --raw needs even steps, leave it out");
    }
    return 1 / mean;
}

void add(Values& out, const char* key, std::optional<double> value) {
    if (value) out.emplace_back(key, *value);
}

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double trapezoid(std::span<const double> y, double dt) {
    double sum = 0;
    for (size_t i = 1; i < y.size(); ++i) sum += 0.5 * (y[i] + y[i - 1]) * dt;
    return sum;
}

void add_speed(Values& out, std::span<const double> speed, double rate_hz,
               const SignalOptions& options) {
    const double dt = 1 / rate_hz;
    add(out, "peak_speed_mm_s", *std::max_element(speed.begin(), speed.end()));
    add(out, "sparc", sparc(speed, rate_hz));
    add(out, "ldlj_speed", ldlj_speed(speed, rate_hz));
    add(out, "movements", movement_count(speed, options.movement_threshold_mm_s));
    const int peaks = speed_peaks(speed, options.movement_threshold_mm_s);
    add(out, "speed_peaks", peaks);
    add(out, "speed_peaks_per_min", peaks / (static_cast<double>(speed.size() - 1) * dt) * 60);
    const double idle = idle_time(speed, dt, options.idle_threshold_mm_s);
    add(out, "idle_time_s", idle);
    add(out, "idle_fraction", idle / (static_cast<double>(speed.size() - 1) * dt));
}

/// Size of the movement in space, from the positions that also give the path.
void add_extent(Values& out, const std::vector<Vec3>& position) {
    Vec3 low = position.front(), high = low;
    for (const Vec3& p : position) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double path = path_length(position), volume = (high - low).prod();
    const double straight = (position.back() - position.front()).norm();
    add(out, "bounding_box_volume_mm3", volume);
    if (!(path > 0)) return;
    add(out, "economy_of_motion", straight / path);
    add(out, "economy_of_volume", std::cbrt(volume) / path);
    if (straight > 0) add(out, "path_inefficiency_percent", 100 * (path / straight - 1));
}

bool has_even_steps(const SignalFile& file) {
    const auto& time = file.values[0];
    const double mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (size_t i = 1; i < time.size(); ++i) {
        if (std::abs(time[i] - time[i - 1] - mean) > 0.01 * mean) return false;
    }
    return true;
}

std::vector<double> on_analysis_rate(const std::vector<double>& time,
                                     const std::vector<double>& signal) {
    const double rate = kAnalysisRateHz;
    const auto count = static_cast<size_t>((time.back() - time.front()) * rate + 1e-9) + 1;
    std::vector<double> even(count);
    size_t at = 0;
    for (size_t k = 0; k < count; ++k) {
        const double t = time.front() + static_cast<double>(k) / rate;
        while (at + 2 < time.size() && time[at + 1] < t) ++at;
        const double share = std::clamp((t - time[at]) / (time[at + 1] - time[at]), 0.0, 1.0);
        even[k] = signal[at] + share * (signal[at + 1] - signal[at]);
    }
    return even;
}

/// Tremor of unfiltered positions, as recorded or (uneven steps) on the analysis rate.
void add_tremor(Values& out, const SignalFile& file, size_t axes) {
    const bool even = has_even_steps(file);
    const double rate_hz = even ? rate_of(file, false) : kAnalysisRateHz;
    std::vector<std::vector<double>> signals;
    for (size_t axis = 1; axis <= axes; ++axis)
        signals.push_back(even ? file.values[axis]
                               : on_analysis_rate(file.values[0], file.values[axis]));
    const std::optional<Tremor> tremor = tremor_of(signals, rate_hz);
    if (!tremor) return;
    add(out, "tremor_power_mm2", tremor->power);
    add(out, "tremor_rms_mm", std::sqrt(tremor->power));
    add(out, "tremor_acceleration_rms_mm_s2", std::sqrt(tremor->acceleration_power));
}

/// A speed profile as the positions of a track are treated: one filter, one rate.
std::vector<double> filtered_speed(const SignalFile& file, size_t column) {
    std::vector<Vec3> line;
    for (const double speed : file.values[column]) line.emplace_back(speed, 0, 0);
    std::vector<double> filtered;
    for (const Vec3& point : make_track(file.values[0], line, {}).position_m)
        filtered.push_back(point.x());
    return filtered;
}

}  // namespace

Values speed_metrics(const SignalFile& file, const SignalOptions& options) {
    const double recorded = rate_of(file, options.raw);
    const double rate = options.raw ? recorded : kAnalysisRateHz;
    const std::vector<double> speed = options.raw ? file.values[1] : filtered_speed(file, 1);
    Values out;
    add(out, "time_s", file.values[0].back() - file.values[0].front());
    add(out, "path_length_mm", trapezoid(speed, 1 / rate));
    add_speed(out, speed, rate, options);
    return out;
}

Values pose_metrics(const SignalFile& file, const SignalOptions& options) {
    const auto& v = file.values;
    const size_t count = v[0].size();
    double rate = rate_of(file, options.raw);
    std::vector<Vec3> position(count), velocity;
    std::vector<Quat> orientation;
    const size_t axes = v.size() == 2 ? 1 : 3;
    for (size_t i = 0; i < count; ++i)
        position[i] = axes == 1 ? Vec3(v[1][i], 0, 0) : Vec3(v[1][i], v[2][i], v[3][i]);
    for (size_t i = 0; v.size() == 8 && i < count; ++i) {
        const Quat q(v[4][i], v[5][i], v[6][i], v[7][i]);
        if (!(q.norm() > 0.5))
            throw SignalError(file.path + ":" + std::to_string(file.line(i)) +
                              ": qw..qz: not a rotation; expected a quaternion of length 1");
        orientation.push_back(q.normalized());
    }
    std::vector<double> speed;
    const double recorded_path = path_length(position);
    if (options.raw) {
        for (size_t i = 0; i + 1 < count; ++i)
            velocity.emplace_back((position[i + 1] - position[i]) * rate);
        for (const Vec3& one : velocity) speed.push_back(one.norm());
    } else {
        const Track track = make_track(v[0], position, orientation);
        rate = kAnalysisRateHz;
        position = track.position_m;  // Millimetres here: the track keeps the unit it is given.
        orientation = track.orientation;
        velocity = track.velocity_m_s;
        speed = track.speed_m_s;
    }
    if (speed.size() < 3)
        throw SignalError(file.path + ": too short; expected at least 0.03 s of movement");
    Values out;
    const double time = v[0].back() - v[0].front();
    add(out, "time_s", time);
    add(out, "path_length_mm", path_length(position));
    // Tremor and noise lengthen it: what the filter took away is worth knowing.
    if (!options.raw) add(out, "path_length_recorded_mm", recorded_path);
    add(out, "mean_speed_mm_s", path_length(position) / time);
    add_speed(out, speed, rate, options);
    add(out, "ldlj_vector", ldlj_vector(velocity, rate));
    add(out, "jerk_normalised", normalised_jerk(velocity, rate));
    add(out, "translational_actions", action_count(speed, 1 / rate, kActionMmS));
    if (axes == 3) add_extent(out, position);
    add_tremor(out, file, axes);
    if (!orientation.empty()) {
        add(out, "depth_path_mm", depth_path(position, orientation));
        add(out, "angular_path_deg", angular_path(orientation) * kDegrees);
        add(out, "roll_path_deg", roll_path(orientation) * kDegrees);
        const auto pivot = pivot_paths(orientation);
        add(out, "pitch_path_deg", pivot.pitch_rad * kDegrees);
        add(out, "yaw_path_deg", pivot.yaw_rad * kDegrees);
        add(out, "rotational_actions",
            action_count(angular_speed(orientation, 1 / rate), 1 / rate, kActionDegS / kDegrees));
    }
    return out;
}

Values bimanual_metrics(const SignalFile& file, const SignalOptions& options) {
    const double recorded = rate_of(file, options.raw);
    const double rate = options.raw ? recorded : kAnalysisRateHz;
    std::array<std::vector<double>, 2> speed{file.values[1], file.values[2]};
    if (!options.raw) speed = {filtered_speed(file, 1), filtered_speed(file, 2)};
    const auto b =
        bimanual_dexterity(speed[0], speed[1], 1 / rate, options.bimanual_threshold_mm_s);
    Values out;
    add(out, "time_s", file.values[0].back() - file.values[0].front());
    add(out, "pearson_r", b.pearson_r);
    add(out, "path_length_left_mm", b.path_left);
    add(out, "path_length_right_mm", b.path_right);
    add(out, "path_ratio_LR", b.path_ratio);
    add(out, "path_balance", b.balance);
    add(out, "both_moving_fraction", b.both);
    add(out, "left_only_fraction", b.left_only);
    add(out, "right_only_fraction", b.right_only);
    add(out, "neither_fraction", b.neither);
    return out;
}

Values unitless_speed_metrics(const SignalFile& file, const SignalOptions& options) {
    // Of a speed without unit only what has none can be said.
    Values values = speed_metrics(file, options);
    std::erase_if(values, [](const auto& each) {
        return each.first != "time_s" && each.first != "sparc" && each.first != "ldlj_speed";
    });
    return values;
}

}  // namespace placode::assessment

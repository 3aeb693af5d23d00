// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/motion_metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/statistics.h"

namespace placode::assessment {

namespace {

constexpr double kMovementMmS = 20;  // ICSAD-like counting
constexpr double kIdleMmS = 1;       // the incision itself runs at about 3 mm/s

std::vector<size_t> instruments(const sim::Recording& recording) {
    std::vector<size_t> tools;
    for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
        if (recording.header.tools[i].kind != sim::ToolKind::kScope) tools.push_back(i);
    }
    return tools;
}

/// First sample at which an instrument is in view; the start when none ever is.
double first_in_view_s(const sim::Recording& recording, const std::vector<size_t>& tools) {
    for (const sim::Sample& sample : recording.samples) {
        for (const size_t tool : tools) {
            if (sample.tools[tool].in_view != 0) return sample.time_s;
        }
    }
    return recording.samples.empty() ? 0 : recording.samples.front().time_s;
}

double task_time_s(const sim::Recording& recording, const std::vector<size_t>& tools) {
    const double end_s = std::max(recording.end.duration_s, recording.samples.back().time_s);
    return std::max(0.0, end_s - first_in_view_s(recording, tools));
}

double out_of_view_s(const sim::Recording& recording, const std::vector<size_t>& tools) {
    double hidden_s = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (const size_t tool : tools) {
            if (sample.tools[tool].in_view == 0) hidden_s += recording.header.sample_s;
        }
    }
    return hidden_s;
}

struct Smoothness {
    std::vector<double> sparc, ldlj, ldlj_speed;
};

void add_smoothness(const Track& track, Smoothness& out) {
    const double rate_hz = 1 / track.dt_s;
    const std::span<const double> speed = track.speed_m_s;
    const std::span<const Vec3> velocity = track.velocity_m_s;
    for (const auto& [first, last] :
         movement_segments(speed, track.dt_s, kSegmentMmS * 1e-3, kSegmentShortestS)) {
        if (const auto s = sparc(speed.subspan(first, last - first), rate_hz))
            out.sparc.push_back(*s);
        if (const auto l = ldlj_vector(velocity.subspan(first, last - first), rate_hz))
            out.ldlj.push_back(*l);
        if (const auto l = ldlj_speed(speed.subspan(first, last - first), rate_hz))
            out.ldlj_speed.push_back(*l);
    }
}

/// All instruments below the idle speed and no pedal down [s].
double idle_seconds(const sim::Recording& recording, const std::vector<const Track*>& tracks,
                    const std::vector<size_t>& tools) {
    size_t n = SIZE_MAX;
    for (const Track* track : tracks) n = std::min(n, track->speed_m_s.size());
    if (n == SIZE_MAX || n < 2) return 0;
    double idle = 0;
    size_t sample = 0;
    for (size_t k = 0; k + 1 < n; ++k) {
        const double t = tracks.front()->time_s(k);
        while (sample + 1 < recording.samples.size() && recording.samples[sample].time_s < t)
            ++sample;
        bool still = true;
        for (size_t i = 0; i < tools.size(); ++i) {
            still = still && tracks[i]->speed_m_s[k] < kIdleMmS * 1e-3 &&
                    recording.samples[sample].tools[tools[i]].pedals == 0;
        }
        if (still) idle += tracks.front()->dt_s;
    }
    return idle;
}

}  // namespace

double path_length(std::span<const Vec3> positions) noexcept {
    double length = 0;
    for (size_t k = 1; k < positions.size(); ++k)
        length += (positions[k] - positions[k - 1]).norm();
    return length;
}

double depth_path(std::span<const Vec3> positions, std::span<const Quat> orientations) noexcept {
    double length = 0;
    for (size_t k = 1; k < std::min(positions.size(), orientations.size()); ++k) {
        const Vec3 shaft = orientations[k - 1] * Vec3::UnitZ();
        length += std::abs((positions[k] - positions[k - 1]).dot(shaft));
    }
    return length;
}

double angular_path(std::span<const Quat> orientations) noexcept {
    double angle = 0;
    for (size_t k = 1; k < orientations.size(); ++k) {
        const Quat d = orientations[k] * orientations[k - 1].conjugate();
        angle += 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
    }
    return angle;
}

int movement_count(std::span<const double> speed, double threshold) noexcept {
    int count = 0;
    bool armed = true;
    for (const double v : speed) {
        if (armed && v >= threshold) {
            ++count;
            armed = false;
        } else if (v < threshold / 2) {
            armed = true;
        }
    }
    return count;
}

double idle_time(std::span<const double> speed, double dt_s, double threshold) noexcept {
    double idle = 0;
    for (size_t k = 0; k + 1 < speed.size(); ++k) {
        if (speed[k] < threshold) idle += dt_s;
    }
    return idle;
}

std::vector<std::pair<size_t, size_t>> movement_segments(std::span<const double> speed, double dt_s,
                                                         double threshold, double shortest_s) {
    std::vector<std::pair<size_t, size_t>> segments;
    for (size_t k = 0; k < speed.size();) {
        if (speed[k] < threshold) {
            ++k;
            continue;
        }
        size_t end = k;
        while (end < speed.size() && speed[end] >= threshold) ++end;
        if (static_cast<double>(end - k) * dt_s >= shortest_s) segments.emplace_back(k, end);
        k = end;
    }
    return segments;
}

Track tool_track(const sim::Recording& recording, size_t tool) {
    std::vector<double> time;
    std::vector<Vec3> position;
    std::vector<Quat> orientation;
    for (const sim::Sample& sample : recording.samples) {
        const sim::ToolSample& s = sample.tools[tool];
        time.push_back(sample.time_s);
        position.emplace_back(s.tip_m[0], s.tip_m[1], s.tip_m[2]);
        orientation.emplace_back(s.orientation[0], s.orientation[1], s.orientation[2],
                                 s.orientation[3]);
    }
    return make_track(time, position, orientation);
}

const Track& ToolTracks::of(size_t tool) {
    std::optional<Track>& track = tracks_.at(tool);
    if (!track) track = tool_track(recording_, tool);
    return *track;
}

double task_start_s(const sim::Recording& recording) {
    return first_in_view_s(recording, instruments(recording));
}

void add_time_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    if (recording.samples.empty()) return;
    const std::vector<size_t> tools = instruments(recording);
    out.push_back({"task_time_s", task_time_s(recording, tools)});
    if (recording.samples.size() > 1 && !tools.empty())
        out.push_back({"out_of_view_s", out_of_view_s(recording, tools)});
}

void add_motion_metrics(ToolTracks& tool_tracks, std::vector<Metric>& out) {
    const sim::Recording& recording = tool_tracks.recording();
    if (recording.samples.empty()) return;
    const std::vector<size_t> tools = instruments(recording);
    const double time_s = task_time_s(recording, tools);
    out.push_back({"task_time_s", time_s});

    std::vector<const Track*> tracks;
    for (const size_t tool : tools)
        if (const Track& track = tool_tracks.of(tool); !track.empty()) tracks.push_back(&track);
    if (tracks.empty() || tracks.size() != tools.size()) return;

    double path_m = 0, depth_m = 0, turn_rad = 0;
    int movements = 0;
    Smoothness smoothness;
    for (const Track* track : tracks) {
        path_m += path_length(track->position_m);
        depth_m += depth_path(track->position_m, track->orientation);
        turn_rad += angular_path(track->orientation);
        movements += movement_count(track->speed_m_s, kMovementMmS * 1e-3);
        add_smoothness(*track, smoothness);
    }
    out.push_back({"path_length_mm", path_m * 1e3});
    out.push_back({"depth_path_mm", depth_m * 1e3});
    out.push_back({"angular_path_deg", turn_rad * 180 / std::numbers::pi});
    if (time_s > 0) out.push_back({"mean_speed_mm_s", path_m * 1e3 / time_s});
    out.push_back({"movements", static_cast<double>(movements)});
    const double idle_s = idle_seconds(recording, tracks, tools);
    out.push_back({"idle_time_s", idle_s});
    if (time_s > 0) out.push_back({"idle_percent", 100 * std::min(1.0, idle_s / time_s)});
    if (!smoothness.sparc.empty()) out.push_back({"sparc", median_of(smoothness.sparc)});
    if (!smoothness.ldlj.empty()) out.push_back({"ldlj_vector", median_of(smoothness.ldlj)});
    if (!smoothness.ldlj_speed.empty())
        out.push_back({"ldlj_speed", median_of(smoothness.ldlj_speed)});

    out.push_back({"out_of_view_s", out_of_view_s(recording, tools)});
}

}  // namespace placode::assessment

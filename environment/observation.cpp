// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/observation.h"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "curriculum/attempt_sample.h"
#include "sim/cutting/attempt_progress.h"

namespace placode::environment {

namespace {

using sim::Vec3;

constexpr double kMm = 1000;

double to_line_m(std::span<const Vec3> line, const Vec3& from) {
    double nearest = 1;
    for (const Vec3& point : line) nearest = std::min(nearest, (point - from).norm());
    return nearest;
}

/// Only in scenes with a needle. It comes with the first frame: before, it is where the jaws will
/// have it (sim/step/needle_jaws.cpp, place_in_jaws()).
sim::Pose needle_pose(const Sight& s) {
    if (s.seen.needle) return s.seen.X_WN;
    for (size_t t = 0; t < s.scene.tools.size(); ++t)
        if (s.scene.tools[t].kind == sim::ToolKind::kNeedleDriver && s.hands.engaged(t))
            return s.poses[t] * s.scene.needle_start.X_TN;
    return {};
}

const Vec3& tip_of(const Sight& s, size_t i) { return s.poses[i].p; }

/// Of the attempt. A name stands beside what it means.
struct Number {
    std::string_view name;
    double (*value)(const Sight&);
};
constexpr Number kProgress[] = {
    {"time_s", [](const Sight& s) { return s.state.time_s; }},
    {"time_left_s", [](const Sight& s) { return std::max(0.0, s.time_limit_s - s.state.time_s); }},
    {"phase", [](const Sight& s) { return static_cast<double>(s.state.phase); }},
    {"points", [](const Sight& s) { return s.points; }},
    {"steps_done", [](const Sight& s) { return static_cast<double>(s.seen.practice.index); }},
    {"steps", [](const Sight& s) { return static_cast<double>(s.seen.practice.count); }},
    {"step_progress", [](const Sight& s) { return s.seen.practice.progress; }},
    {"ring_cut", [](const Sight& s) { return sim::ring_share(s.state); }},
    {"released", [](const Sight& s) { return static_cast<double>(s.seen.released); }},
    {"marked_gone",
     [](const Sight& s) { return std::max(0.0, sim::gone_share(s.scene, s.state)); }},
    {"marked_taken_out",
     [](const Sight& s) { return std::max(0.0, sim::taken_out_share(s.scene, s.state)); }},
    {"pieces_out", [](const Sight& s) { return static_cast<double>(s.seen.pieces_out); }},
    {"placode_peak_c",
     [](const Sight& s) { return static_cast<double>(s.state.ledger.placode_peak_c); }},
    {"placode_now_c",
     [](const Sight& s) { return static_cast<double>(s.state.ledger.placode_now_c); }},
    {"placode_peak_cem43_min",
     [](const Sight& s) { return static_cast<double>(s.state.ledger.placode_peak_cem43_min); }},
    {"placode_burned_mm3",
     [](const Sight& s) { return 1e9 * static_cast<double>(s.state.ledger.placode_burned_m3); }},
    {"removed_mm3", [](const Sight& s) { return 1e9 * static_cast<double>(s.state.removed_m3); }},
};

/// Of a tool: first what has three axes.
struct ToolVector {
    std::string_view name, unit;
    Vec3 (*value)(const Sight&, size_t);
};
constexpr ToolVector kToolVectors[] = {
    {"tip", "_mm", [](const Sight& s, size_t i) -> Vec3 { return kMm * tip_of(s, i); }},
    {"shaft", "", [](const Sight& s, size_t i) -> Vec3 { return s.poses[i].q * Vec3::UnitZ(); }},
    {"force", "_n", [](const Sight& s, size_t i) -> Vec3 { return s.state.tools[i].force_n; }},
    {"to_goal", "_mm",
     [](const Sight& s, size_t i) -> Vec3 {
         const auto& goal = s.goals.place_m[i];
         return goal ? Vec3(kMm * (*goal - s.goals.from_m[i])) : Vec3(Vec3::Zero());
     }},
};

struct ToolNumber {
    std::string_view name;
    double (*value)(const Sight&, size_t);
};
constexpr ToolNumber kToolNumbers[] = {
    {"has_goal", [](const Sight& s, size_t i) { return s.goals.place_m[i] ? 1.0 : 0; }},
    {"roll_rad", [](const Sight& s, size_t i) { return s.hands.roll_rad(i); }},
    {"jaw_rad",
     [](const Sight& s, size_t i) { return static_cast<double>(s.state.tools[i].jaw_rad); }},
    {"engaged", [](const Sight& s, size_t i) { return s.hands.engaged(i) ? 1.0 : 0; }},
    {"in_view", [](const Sight& s,
                   size_t i) { return curriculum::tip_in_view(s.scene, s.state, i) ? 1.0 : 0; }},
    {"contact", [](const Sight& s, size_t i) { return s.state.tools[i].in_contact ? 1.0 : 0; }},
    {"tip_gap_mm", [](const Sight& s, size_t i) { return kMm * s.state.tools[i].tip_gap_m; }},
    {"power_w", [](const Sight& s, size_t i) { return s.state.tools[i].power_in_tissue_w; }},
    {"holds", [](const Sight& s, size_t i) { return s.seen.holds[i] ? 1.0 : 0; }},
    {"pull_n", [](const Sight& s, size_t i) { return s.seen.pull_n[i]; }},
    {"to_placode_mm", [](const Sight& s, size_t i) { return kMm * s.seen.placode_gap_m[i]; }},
    {"to_plan_mm",
     [](const Sight& s, size_t i) { return kMm * to_line_m(s.seen.contour, tip_of(s, i)); }},
};

/// Of the suture needle, in scenes that have one: last, so that the others keep their places.
constexpr ToolVector kNeedleVectors[] = {
    {"point", "_mm",
     [](const Sight& s, size_t) -> Vec3 {
         return kMm * (needle_pose(s) * s.scene.suture->needle().tip_m());
     }},
    {"point_ahead", "",
     [](const Sight& s, size_t) -> Vec3 { return needle_pose(s).q * sim::Needle::forward(); }},
    {"swage", "_mm",
     [](const Sight& s, size_t) -> Vec3 {
         return kMm * (needle_pose(s) * Vec3(-s.scene.suture->needle().tip_m()));
     }},
};
constexpr Number kNeedleNumbers[] = {
    {"held", [](const Sight& s) { return s.seen.needle_held || !s.seen.needle ? 1.0 : 0; }},
    {"bites", [](const Sight& s) { return static_cast<double>(s.seen.bites); }},
    {"exits", [](const Sight& s) { return static_cast<double>(s.seen.exits); }},
    {"drawn_through", [](const Sight& s) { return static_cast<double>(s.seen.drawn_through); }},
    {"point_n", [](const Sight& s) { return static_cast<double>(s.state.suturing.point_n); }},
    {"thread_n", [](const Sight& s) { return static_cast<double>(s.state.suturing.thread_n); }},
};

constexpr const char* kAxes[] = {"_x", "_y", "_z"};

}  // namespace

std::vector<std::string> observation_names(size_t tools, bool needle) {
    std::vector<std::string> names;
    for (const Number& number : kProgress) names.emplace_back(number.name);
    for (size_t i = 0; i < kFieldHarms; ++i) names.push_back("harm." + std::string(kHarms[i].name));
    for (size_t i = 0; i < tools; ++i) {
        const std::string tool = "tool" + std::to_string(i) + ".";
        for (const ToolVector& vector : kToolVectors)
            for (const char* axis : kAxes)
                names.push_back(tool + std::string(vector.name) + axis + std::string(vector.unit));
        for (const ToolNumber& number : kToolNumbers)
            names.push_back(tool + std::string(number.name));
    }
    if (!needle) return names;
    for (const ToolVector& vector : kNeedleVectors)
        for (const char* axis : kAxes)
            names.push_back("needle." + std::string(vector.name) + axis + std::string(vector.unit));
    for (const Number& number : kNeedleNumbers)
        names.push_back("needle." + std::string(number.name));
    for (size_t i = kFieldHarms; i < kHarms.size(); ++i)
        names.push_back("harm." + std::string(kHarms[i].name));
    return names;
}

void observe(const Sight& sight, std::span<double> out) {
    size_t at = 0;
    for (const Number& number : kProgress) out[at++] = number.value(sight);
    const auto harms = sight.book.harms();
    for (const double harm : harms.first(kFieldHarms)) out[at++] = harm;
    for (size_t i = 0; i < sight.scene.tools.size(); ++i) {
        for (const ToolVector& vector : kToolVectors) {
            const Vec3 value = vector.value(sight, i);
            for (int k = 0; k < 3; ++k) out[at++] = value[k];
        }
        for (const ToolNumber& number : kToolNumbers) out[at++] = number.value(sight, i);
    }
    if (sight.scene.suture) {
        for (const ToolVector& vector : kNeedleVectors) {
            const Vec3 value = vector.value(sight, 0);
            for (int k = 0; k < 3; ++k) out[at++] = value[k];
        }
        for (const Number& number : kNeedleNumbers) out[at++] = number.value(sight);
        for (const double harm : harms.subspan(kFieldHarms)) out[at++] = harm;
    }
    assert(at == out.size());
}

}  // namespace placode::environment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/goals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::environment {

namespace {

using sim::Vec3;

/// The stretches of the planned line that are followed, point by point.
std::optional<Vec3> nearest_untraced(const haptics::Perception& seen, const Vec3& from) {
    std::optional<Vec3> nearest;
    const size_t points = seen.contour.size();
    for (size_t i = 0; i < points; ++i) {
        if (seen.practice.traced[i * sim::kTraceBins / points] != 0) continue;
        if (!nearest || (seen.contour[i] - from).norm() < (*nearest - from).norm())
            nearest = seen.contour[i];
    }
    return nearest;
}

/// Where the wire of the suture needle is taken, from its point [m]: to bite, and to be drawn out.
constexpr double kTakeToBiteShare = 2.0 / 3, kTakeBehindPointM = 0.0013;

/// Place on the needle's half circle, from its point (sim/suture/needle.h).
Vec3 wire_place(const haptics::Perception& seen, double arc_m) {
    const double radius = seen.needle_arc_m / std::numbers::pi, angle = arc_m / radius;
    return seen.X_WN * Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
}

/// Of a driver in a step with the needle: its point to the mark, or the jaws to the wire.
void needle_goal(const haptics::Perception& seen, size_t tool, ToolGoals& goals) {
    const sim::PracticeGoal& practice = seen.practice;
    const sim::PracticeKind kind = practice.step.kind;
    if (!seen.needle || kind == sim::PracticeKind::kNeedleThrough ||
        kind == sim::PracticeKind::kThreadDraw)
        return;
    if (kind == sim::PracticeKind::kNeedleLay) {
        if (seen.holds_needle[tool]) goals.place_m[tool] = practice.target_m[0];
        return;
    }
    if (kind == sim::PracticeKind::kNeedleTake) {
        const double share = practice.step.take_share;
        goals.place_m[tool] =
            wire_place(seen, share > 0 ? share * seen.needle_arc_m : kTakeBehindPointM);
        return;
    }
    const int mark = kind == sim::PracticeKind::kNeedleOut ? 1 : 0;
    if (mark >= practice.targets) return;
    const Vec3 wanted = practice.target_m[static_cast<size_t>(mark)];
    const Vec3 point = wire_place(seen, 0);
    // Held by the other hand it is still to be taken.
    const bool held =
        kind == sim::PracticeKind::kNeedleShow ? seen.holds_needle[tool] : seen.needle_held;
    if (held) {
        goals.place_m[tool] = wanted;
        goals.from_m[tool] = point;
    } else {
        // Nothing is gained by dropping it: its own way is still to go.
        goals.place_m[tool] = wire_place(seen, kTakeToBiteShare * seen.needle_arc_m);
        goals.after_m[tool] = (wanted - point).norm();
    }
}

/// Of the patch: its middle to the placode's. It is drawn by what holds it.
void patch_goal(const haptics::Perception& seen, size_t tool, ToolGoals& goals) {
    const sim::PracticeGoal& practice = seen.practice;
    const Vec3 wanted = practice.target_m[0], middle = practice.target_m[1];
    if (seen.holds[tool]) {
        goals.place_m[tool] = wanted;
        goals.from_m[tool] = middle;
    } else {
        goals.place_m[tool] = middle;
        goals.after_m[tool] = (wanted - middle).norm();
    }
}

bool is_needle_step(sim::PracticeKind kind) {
    return kind == sim::PracticeKind::kNeedleIn || kind == sim::PracticeKind::kNeedleOut ||
           kind == sim::PracticeKind::kNeedleTake || kind == sim::PracticeKind::kNeedleThrough ||
           kind == sim::PracticeKind::kThreadDraw || kind == sim::PracticeKind::kNeedleShow ||
           kind == sim::PracticeKind::kNeedleLay;
}

/// Of a task with steps: only the hands of the present one have a goal.
void practice_goals(std::span<const sim::ToolSpec> tools, const haptics::Perception& seen,
                    std::span<const Vec3> tips, ToolGoals& goals) {
    const sim::PracticeGoal& practice = seen.practice;
    goals.reached = practice.index * (sim::kTraceBins + 1);
    // What a patch overlaps may come and go while it is drawn.
    if (!practice.margin)
        goals.reached += std::count(practice.traced.begin(), practice.traced.end(), 1);
    // A needle that comes with the first frame brings its goal along.
    if (seen.needle) ++goals.reached;
    if (practice.index >= practice.count) return;
    const sim::PracticeKind kind = practice.step.kind;
    for (size_t i = 0; i < tools.size(); ++i) {
        if (kind == sim::PracticeKind::kTraction) {
            // Both hands take hold of their own target, then pull: no place any more.
            const size_t target = tools[i].hand == sim::Hand::kRight ? 0 : 1;
            if (tools[i].hand == sim::Hand::kCamera || static_cast<int>(target) >= practice.targets)
                continue;
            goals.place_m[i] = seen.holds[i] ? tips[i] : practice.target_m[target];
        } else if (tools[i].hand == practice.step.hand) {
            if (is_needle_step(kind))
                needle_goal(seen, i, goals);
            else if (practice.margin && practice.targets == 2)
                patch_goal(seen, i, goals);
            else if (kind == sim::PracticeKind::kTrace)
                goals.place_m[i] = nearest_untraced(seen, tips[i]);
            else if (practice.targets > 0)
                goals.place_m[i] = practice.target_m[0];
        }
    }
}

/// Of a task on the whole field: every instrument has its own work.
void field_goals(std::span<const sim::ToolSpec> tools, const haptics::Perception& seen,
                 std::span<const Vec3> tips, ToolGoals& goals) {
    goals.reached = std::count(seen.contour_cut.begin(), seen.contour_cut.end(), 1) +
                    std::count(seen.outline_cut.begin(), seen.outline_cut.end(), 1) +
                    1000L * seen.pieces_out;
    for (size_t i = 0; i < tools.size(); ++i) {
        const sim::ToolKind kind = tools[i].kind;
        if (kind == sim::ToolKind::kNeedle || kind == sim::ToolKind::kHook)
            goals.place_m[i] = nearest_undone(seen.contour, seen.contour_cut, tips[i]);
        else if (kind == sim::ToolKind::kScissors)
            goals.place_m[i] = nearest_undone(seen.outline, seen.outline_cut, tips[i]);
        else if (kind == sim::ToolKind::kGrasper && seen.holds[i])
            goals.place_m[i] = tips[i];
        else if (kind == sim::ToolKind::kGrasper && !seen.outline.empty())
            goals.place_m[i] = seen.grasp_place_m;
        else if (kind == sim::ToolKind::kGrasper)
            goals.place_m[i] = nearest_undone(seen.contour, seen.contour_cut, tips[i]);
    }
}

}  // namespace

std::optional<Vec3> nearest_undone(std::span<const Vec3> points, std::span<const uint8_t> done,
                                   const Vec3& from) {
    std::optional<Vec3> nearest;
    for (size_t i = 0; i < std::min(points.size(), done.size()); ++i) {
        if (done[i] != 0) continue;
        if (!nearest || (points[i] - from).norm() < (*nearest - from).norm()) nearest = points[i];
    }
    return nearest;
}

ToolGoals goals_of(std::span<const sim::ToolSpec> tools, const haptics::Perception& seen,
                   std::span<const Vec3> tips) {
    ToolGoals goals;
    for (size_t i = 0; i < tools.size(); ++i) goals.from_m[i] = tips[i];
    if (seen.practice.count > 0)
        practice_goals(tools, seen, tips, goals);
    else
        field_goals(tools, seen, tips, goals);
    for (size_t i = 0; i < tools.size(); ++i)
        if (goals.place_m[i])
            goals.away_m[i] = goals.after_m[i] + (*goals.place_m[i] - goals.from_m[i]).norm();
    return goals;
}

}  // namespace placode::environment

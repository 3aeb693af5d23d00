// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/goals.h"

#include <algorithm>

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

/// Of a task with steps: only the hands of the present one have a goal.
void practice_goals(std::span<const sim::ToolSpec> tools, const haptics::Perception& seen,
                    std::span<const Vec3> tips, ToolGoals& goals) {
    const sim::PracticeGoal& practice = seen.practice;
    goals.reached = practice.index * (sim::kTraceBins + 1) +
                    std::count(practice.traced.begin(), practice.traced.end(), 1);
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
            if (kind == sim::PracticeKind::kTrace)
                goals.place_m[i] = nearest_untraced(seen, tips[i]);
            else if (practice.targets > 0)
                goals.place_m[i] = practice.target_m[kind == sim::PracticeKind::kNeedleOut ? 1 : 0];
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
    if (seen.practice.count > 0)
        practice_goals(tools, seen, tips, goals);
    else
        field_goals(tools, seen, tips, goals);
    for (size_t i = 0; i < tools.size(); ++i)
        if (goals.place_m[i]) goals.away_m[i] = (*goals.place_m[i] - tips[i]).norm();
    return goals;
}

}  // namespace placode::environment

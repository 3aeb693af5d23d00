// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/first_view.h"

#include <vector>

namespace placode::curriculum {
namespace {

/// In the field's plane [m].
std::vector<sim::Vec2> places_of_work(const Task& task) {
    if (task.scene.slit) return {task.scene.slit->from_m, task.scene.slit->to_m};
    std::vector<sim::Vec2> places;
    for (const TaskStep& step : task.steps) {
        const auto count = static_cast<size_t>(sim::targets_of(step.goal.kind));
        for (size_t i = 0; step.goal.placed && i < count; ++i)
            places.push_back(step.goal.place_m[i]);
    }
    return places;
}

}  // namespace

void aim_scopes(Task& task) {
    const std::vector<sim::Vec2> places = places_of_work(task);
    if (places.empty()) return;
    sim::Vec2 low = places.front(), high = places.front();
    for (const sim::Vec2& place : places) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    const sim::Vec2 middle = (low + high) / 2;
    for (sim::ToolSpec& tool : task.scene.tools)
        if (tool.kind == sim::ToolKind::kScope) tool.look_at_m = {middle.x(), middle.y(), 0};
}

}  // namespace placode::curriculum

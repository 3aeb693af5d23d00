// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/task_scope.h"

#include <algorithm>

#include "reports/metric_groups.h"

namespace placode::reports {
namespace {

using sim::ToolKind;

bool begins(std::string_view id, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view each) { return id.starts_with(each); });
}

bool snips(std::string_view id) { return begins(id, {"snips", "skin_snip", "placode_snip"}); }
bool takes_out(std::string_view id) { return begins(id, {"pieces", "resected", "marked"}); }

/// Heat in the placode: a probe brings none.
bool heats(std::string_view id) {
    return begins(id, {"placode_energised", "placode_peak_cem43", "placode_peak_c",
                       "placode_arrhenius", "placode_overheated", "placode_burned"});
}

bool held(std::string_view id) {
    return begins(id, {"grasps", "lift_hold", "slip_", "crush_", "over_traction", "peak_traction"});
}

/// Has the task what this metric is about?
bool has(const TaskScope& scope, std::string_view id) {
    if (snips(id)) return scope.scissors;
    if (takes_out(id)) return scope.resection;
    if (held(id)) return scope.jaws;
    if (heats(id)) return scope.energy && scope.placode;
    if (begins(id, {"skin_burned", "skin_heat"})) return scope.energy;
    switch (group_of_metric(id)) {
        case MetricGroup::kIncision:
            return id.starts_with("released") ? scope.ring || scope.resection : scope.ring;
        case MetricGroup::kPlacode:
            return scope.placode;
        case MetricGroup::kEnergy:
            return scope.energy;
        case MetricGroup::kHands:
            return scope.hands;
        default:
            return true;
    }
}

}  // namespace

TaskScope scope_of(const std::vector<sim::ToolSpec>& tools,
                   const std::vector<std::string>& scored) {
    const auto holds = [&](std::initializer_list<ToolKind> kinds) {
        return std::any_of(tools.begin(), tools.end(), [&](const sim::ToolSpec& tool) {
            return std::find(kinds.begin(), kinds.end(), tool.kind) != kinds.end();
        });
    };
    const auto any_scored = [&](const auto& fits) {
        return scored.empty() || std::any_of(scored.begin(), scored.end(), fits);
    };
    TaskScope scope;
    scope.scored = scored;
    scope.energy = holds({ToolKind::kNeedle, ToolKind::kHook});
    scope.scissors = holds({ToolKind::kScissors});
    scope.jaws = scope.scissors || holds({ToolKind::kGrasper});
    scope.ring = (scope.energy || scope.scissors) && (scored.empty() || looks_at_ring(scored));
    scope.resection = scope.jaws && any_scored(takes_out);
    scope.line = scope.ring || scope.resection ||
                 any_scored([](const std::string& id) { return id.starts_with("trace_"); });
    scope.hands = std::count_if(tools.begin(), tools.end(), [](const sim::ToolSpec& tool) {
                      return tool.kind != ToolKind::kScope;
                  }) > 1;
    return scope;
}

TaskScope scope_of(const curriculum::Task& task) {
    std::vector<std::string> scored;
    for (const assessment::RubricItem& item : task.rubric.items) scored.push_back(item.metric);
    TaskScope scope = scope_of(task.scene.tools, scored);
    scope.force_limit_n = task.scene.contact.over_force_n;
    for (const curriculum::TaskStep& step : task.steps)
        scope.line = scope.line || step.goal.kind == sim::PracticeKind::kTrace;
    return scope;
}

TaskScope scope_of(const sim::RecordingHeader& header) {
    TaskScope scope;
    try {
        scope = scope_of(curriculum::load_task_text(header.task_json, header.task_id));
    } catch (const curriculum::DefinitionError&) {
        scope = scope_of(header.tools, {});
    }
    scope.placode = !header.geometry.placode_edge.empty();
    if (header.geometry.planned_contour.empty()) scope.ring = scope.line = false;
    return scope;
}

bool belongs(const TaskScope& scope, std::string_view metric) {
    return std::find(scope.scored.begin(), scope.scored.end(), metric) != scope.scored.end() ||
           has(scope, metric);
}

bool about_force_limit(std::string_view metric) noexcept {
    return metric.starts_with("over_force") || metric.starts_with("excess_impulse");
}

}  // namespace placode::reports

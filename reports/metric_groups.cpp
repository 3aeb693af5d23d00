// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/metric_groups.h"

#include <algorithm>
#include <array>

namespace placode::reports {
namespace {

constexpr std::array kGroups{
    MetricGroup::kTime,      MetricGroup::kIncision, MetricGroup::kPlacode, MetricGroup::kTissue,
    MetricGroup::kResection, MetricGroup::kEnergy,   MetricGroup::kForce,   MetricGroup::kMotion,
    MetricGroup::kHands,     MetricGroup::kPractice, MetricGroup::kSuture,  MetricGroup::kClosure};

struct Rule {
    std::string_view beginning;
    MetricGroup group;
};

// By the beginning of the id; the first that fits. What begins like nothing here is motion, the
// largest group.
constexpr Rule kRules[]{
    {"task_time", MetricGroup::kTime},
    {"idle_", MetricGroup::kTime},
    {"out_of_view", MetricGroup::kTime},
    {"neither_moving", MetricGroup::kHands},
    {"ring_", MetricGroup::kIncision},
    {"largest_gap", MetricGroup::kIncision},
    {"gap_", MetricGroup::kIncision},
    {"contour_", MetricGroup::kIncision},
    {"kerf_", MetricGroup::kIncision},
    {"off_line", MetricGroup::kIncision},
    {"outside_band", MetricGroup::kIncision},
    {"toward_placode", MetricGroup::kIncision},
    {"released", MetricGroup::kIncision},
    {"cutting_economy", MetricGroup::kIncision},
    {"placode_", MetricGroup::kPlacode},
    {"torn_", MetricGroup::kTissue},
    {"buried_", MetricGroup::kTissue},
    {"over_stretch", MetricGroup::kTissue},
    {"max_stretch", MetricGroup::kTissue},
    {"skin_", MetricGroup::kTissue},
    {"crush_", MetricGroup::kTissue},
    {"snips", MetricGroup::kResection},
    {"pieces", MetricGroup::kResection},
    {"resected", MetricGroup::kResection},
    {"marked", MetricGroup::kResection},
    {"grasps", MetricGroup::kResection},
    {"lift_hold", MetricGroup::kResection},
    {"slip_", MetricGroup::kResection},
    {"energy_", MetricGroup::kEnergy},
    {"dwell_", MetricGroup::kEnergy},
    {"thermal_", MetricGroup::kEnergy},
    {"dose_", MetricGroup::kEnergy},
    {"peak_", MetricGroup::kForce},
    {"over_force", MetricGroup::kForce},
    {"over_traction", MetricGroup::kForce},
    {"mean_force", MetricGroup::kForce},
    {"rms_force", MetricGroup::kForce},
    {"force_", MetricGroup::kForce},
    {"excess_impulse", MetricGroup::kForce},
    {"path_length_left", MetricGroup::kHands},
    {"path_length_right", MetricGroup::kHands},
    {"bimanual_", MetricGroup::kHands},
    {"both_moving", MetricGroup::kHands},
    {"left_only", MetricGroup::kHands},
    {"right_only", MetricGroup::kHands},
    {"steps_", MetricGroup::kPractice},
    {"target_", MetricGroup::kPractice},
    {"trace_", MetricGroup::kPractice},
    {"traction_held", MetricGroup::kPractice},
    {"patch_", MetricGroup::kPractice},
    {"wash_jet", MetricGroup::kPlacode},
    {"wash_", MetricGroup::kPractice},
    {"undermine_fascia", MetricGroup::kTissue},
    {"undermine_", MetricGroup::kPractice},
    {"closing_", MetricGroup::kForce},
    {"bite_", MetricGroup::kSuture},
    {"slit_", MetricGroup::kClosure},
    {"bites_", MetricGroup::kSuture},
    {"needle_handover", MetricGroup::kHands},
    {"needle_", MetricGroup::kSuture},
    {"thread_", MetricGroup::kSuture},
};

bool contains(const std::vector<std::string>& list, std::string_view id) {
    return std::find(list.begin(), list.end(), id) != list.end();
}

/// Counted above a speed that slow hands never reach.
constexpr std::string_view kFastOnly[]{"movements", "translational_actions", "rotational_actions",
                                       "speed_peaks_per_min"};

/// Says what another one has said, or only that nothing was fast.
bool superfluous(std::string_view id, const assessment::MetricSet& metrics) {
    if (id == "neither_moving_percent") return metrics.find("idle_percent").has_value();
    return std::find(std::begin(kFastOnly), std::end(kFastOnly), id) != std::end(kFastOnly) &&
           nothing_moved_fast(metrics) && metrics.find(id).value_or(0) == 0;
}

}  // namespace

const char* group_title(MetricGroup group) noexcept {
    switch (group) {
        case MetricGroup::kTime:
            return "Time and view";
        case MetricGroup::kIncision:
            return "Incision";
        case MetricGroup::kPlacode:
            return "Placode";
        case MetricGroup::kTissue:
            return "Tissue";
        case MetricGroup::kResection:
            return "Grasping and resection";
        case MetricGroup::kEnergy:
            return "Energy and heat";
        case MetricGroup::kForce:
            return "Force";
        case MetricGroup::kMotion:
            return "Motion";
        case MetricGroup::kHands:
            return "Both hands";
        case MetricGroup::kPractice:
            return "Steps of the exercise";
        case MetricGroup::kSuture:
            return "Needle and thread";
        case MetricGroup::kClosure:
            return "Closed wound";
    }
    return "";
}

MetricGroup group_of_metric(std::string_view id) noexcept {
    for (const Rule& rule : kRules)
        if (id.starts_with(rule.beginning)) return rule.group;
    return MetricGroup::kMotion;
}

bool looks_at_ring(const std::vector<std::string>& scored) noexcept {
    return std::any_of(scored.begin(), scored.end(), [](const std::string& id) {
        return group_of_metric(id) == MetricGroup::kIncision;
    });
}

bool nothing_moved_fast(const assessment::MetricSet& metrics) {
    return metrics.find("movements").value_or(1) == 0 &&
           metrics.find("path_length_mm").value_or(0) > 0;
}

std::vector<GroupedMetrics> grouped_metrics(const assessment::MetricSet& metrics,
                                            const TaskScope& scope) {
    std::vector<GroupedMetrics> groups;
    const auto definitions = assessment::metric_definitions();
    for (const MetricGroup group : kGroups) {
        GroupedMetrics shown{group, {}};
        for (const assessment::MetricDefinition& each : definitions) {
            if (group_of_metric(each.id) != group || !metrics.find(each.id)) continue;
            const bool counts = contains(scope.scored, each.id);
            if (counts || (belongs(scope, each.id) && !superfluous(each.id, metrics)))
                shown.metrics.push_back(each);
        }
        if (!shown.metrics.empty()) groups.push_back(std::move(shown));
    }
    return groups;
}

}  // namespace placode::reports

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "assessment/bites.h"
#include "assessment/closure.h"
#include "assessment/handling_metrics.h"
#include "assessment/motion_detail.h"
#include "assessment/motion_metrics.h"
#include "assessment/patch_metrics.h"
#include "assessment/practice.h"
#include "assessment/suture_metrics.h"
#include "assessment/tissue_metrics.h"
#include "assessment/undermine_metrics.h"
#include "assessment/wanted_metrics.h"
#include "assessment/wash_metrics.h"

namespace placode::assessment {

std::optional<double> MetricSet::find(std::string_view id) const {
    for (const Metric& metric : values) {
        if (metric.id == id) return metric.value;
    }
    return std::nullopt;
}

namespace {

// What add_motion_metrics() and add_motion_details() find, less what needs no track.
constexpr std::string_view kFromTracks[] = {"path_length_mm",
                                            "depth_path_mm",
                                            "angular_path_deg",
                                            "mean_speed_mm_s",
                                            "movements",
                                            "idle_time_s",
                                            "idle_percent",
                                            "sparc",
                                            "ldlj_vector",
                                            "ldlj_speed",
                                            "roll_path_deg",
                                            "pitch_path_deg",
                                            "yaw_path_deg",
                                            "economy_of_volume",
                                            "working_volume_mm3",
                                            "economy_of_motion",
                                            "speed_peaks_per_min",
                                            "jerk_normalised",
                                            "translational_actions",
                                            "rotational_actions",
                                            "bimanual_rotation_r",
                                            "path_length_left_mm",
                                            "path_length_right_mm",
                                            "bimanual_r",
                                            "bimanual_balance",
                                            "both_moving_percent",
                                            "left_only_percent",
                                            "right_only_percent",
                                            "neither_moving_percent",
                                            "tremor_rms_mm",
                                            "tremor_acceleration_mm_s2",
                                            "out_of_view_count",
                                            "out_of_view_percent"};

void add_what_needs_no_track(const sim::Recording& recording, std::vector<Metric>& found) {
    add_tissue_metrics(recording, found);
    add_practice_metrics(recording, found);
    add_suture_metrics(recording, found);
    add_handling_metrics(recording, found);
    add_bite_metrics(recording, found);
    add_closure_metrics(recording, found);
    add_patch_metrics(recording, found);
    add_wash_metrics(recording, found);
    add_undermine_metrics(recording, found);
}

/// In the order of the definitions; what is not finite is not known.
MetricSet in_order(const std::vector<Metric>& found) {
    MetricSet set;
    for (const MetricDefinition& definition : metric_definitions()) {
        for (const Metric& metric : found) {
            if (metric.id == definition.id && std::isfinite(metric.value))
                set.values.push_back(metric);
        }
    }
    return set;
}

}  // namespace

MetricSet compute_metrics(const sim::Recording& recording) {
    std::vector<Metric> found;
    ToolTracks tool_tracks(recording);
    add_motion_metrics(tool_tracks, found);
    add_motion_details(tool_tracks, found);
    add_what_needs_no_track(recording, found);
    return in_order(found);
}

std::vector<std::string_view> metrics_of(const Rubric& rubric) {
    std::vector<std::string_view> ids(rubric.attempted_by.begin(), rubric.attempted_by.end());
    for (const RubricItem& item : rubric.items) ids.emplace_back(item.metric);
    return ids;
}

MetricSet compute_metrics(const sim::Recording& recording,
                          std::span<const std::string_view> wanted) {
    for (const std::string_view id : wanted)
        if (std::ranges::find(kFromTracks, id) != std::end(kFromTracks))
            return compute_metrics(recording);
    std::vector<Metric> found;
    add_time_metrics(recording, found);
    add_what_needs_no_track(recording, found);
    return in_order(found);
}

}  // namespace placode::assessment

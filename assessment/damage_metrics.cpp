// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Over-stretch and thermal spread: what the simulation summed up (sim/ledger/damage.h), as metrics.

#include "sim/ledger/damage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/statistics.h"
#include "assessment/tissue_metrics.h"
#include "sim/cutting/attempt_progress.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;

constexpr std::array<std::string_view, 3> kDamageIds{"thermal_spread_mm", "thermal_spread_p95_mm",
                                                     "thermal_spread_max_mm"};
constexpr std::array<std::string_view, 3> kDoseIds{"dose_spread_mm", "dose_spread_p95_mm",
                                                   "dose_spread_max_mm"};
constexpr std::string_view kVolumeTime = "over_stretch_mm3_s";

bool has(const sim::Recording& recording, EventKind kind) {
    return std::any_of(recording.events.begin(), recording.events.end(),
                       [kind](const Event& event) { return event.kind == kind; });
}

/// A needle or a hook, and a line to follow: only then is there an incision by heat.
bool cuts_by_heat(const sim::RecordingHeader& header) {
    if (header.geometry.planned_contour.empty()) return false;
    return std::any_of(header.tools.begin(), header.tools.end(), [](const sim::ToolSpec& tool) {
        return tool.kind == sim::ToolKind::kNeedle || tool.kind == sim::ToolKind::kHook;
    });
}

/// Scissors: only they take pieces.
bool resects(const sim::RecordingHeader& header) {
    return std::any_of(header.tools.begin(), header.tools.end(), [](const sim::ToolSpec& tool) {
        return tool.kind == sim::ToolKind::kScissors;
    });
}

/// Mean, 95th percentile, largest.
void add_spread(std::vector<double> widths_m, const std::array<std::string_view, 3>& ids,
                std::vector<Metric>& out) {
    if (widths_m.empty()) return;
    std::sort(widths_m.begin(), widths_m.end());
    double mean = 0;
    for (const double width : widths_m) mean += width / static_cast<double>(widths_m.size());
    out.push_back({std::string(ids[0]), mean * 1e3});
    out.push_back({std::string(ids[1]), quantile(widths_m, 0.95) * 1e3});
    out.push_back({std::string(ids[2]), widths_m.back() * 1e3});
}

}  // namespace

void add_damage(const sim::Recording& recording, std::vector<Metric>& out) {
    double stretch = 0, volume_time = 0;
    int count = 0;
    bool summed = false;
    std::vector<double> damage_m, dose_m;
    for (const Event& event : recording.events) {
        const auto value = static_cast<double>(event.value);
        const auto value2 = static_cast<double>(event.value2);
        if (event.kind == EventKind::kOverStretch) {
            ++count;
            stretch = std::max(stretch, value);
        } else if (event.kind == sim::EventKind::kStretchSum) {
            summed = true;
            volume_time += value;
            stretch = std::max(stretch, value2);
        } else if (event.kind == sim::EventKind::kThermalSpread && event.element >= 0) {
            if (std::isfinite(value)) damage_m.push_back(value);
            if (std::isfinite(value2)) dose_m.push_back(value2);
        }
    }
    out.push_back({"over_stretch_count", static_cast<double>(count)});
    if (stretch > 0) out.push_back({"max_stretch", stretch});
    if (summed) out.push_back({std::string(kVolumeTime), volume_time * 1e9});
    add_spread(std::move(damage_m), kDamageIds, out);
    add_spread(std::move(dose_m), kDoseIds, out);
}

bool has_ledger(const sim::Recording& recording) noexcept {
    return std::any_of(recording.events.begin(), recording.events.end(), [](const Event& event) {
        return event.kind == sim::EventKind::kLedgerWritten && event.value >= sim::kLedgerVersion;
    });
}

std::vector<std::string_view> not_recorded(const sim::Recording& recording) {
    std::vector<std::string_view> missing;
    if (!has_ledger(recording)) {
        missing.insert(missing.end(), {"buried_s", "buried_count"});
        if (resects(recording.header)) missing.push_back("resected_percent");
    }
    if (resects(recording.header) && !has(recording, sim::EventKind::kMarkedLost))
        missing.insert(missing.end(), {"marked_lost_percent", "marked_gone_percent"});
    if (!recording.header.geometry.planned_contour.empty() &&
        !has(recording, sim::EventKind::kRingGap))
        missing.insert(missing.end(), {"largest_gap_mm", "gap_count"});
    if (has(recording, sim::EventKind::kWatertight) && !has(recording, sim::EventKind::kSlitOpened))
        missing.push_back("slit_burst_mm");
    if (!has(recording, sim::EventKind::kStretchSum)) missing.push_back(kVolumeTime);
    if (cuts_by_heat(recording.header) && !has(recording, sim::EventKind::kThermalSpread)) {
        missing.insert(missing.end(), kDamageIds.begin(), kDamageIds.end());
        missing.insert(missing.end(), kDoseIds.begin(), kDoseIds.end());
    }
    return missing;
}

}  // namespace placode::assessment

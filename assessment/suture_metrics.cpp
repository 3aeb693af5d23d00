// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/suture_metrics.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "assessment/bites.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;

const Event* last_of(const sim::Recording& recording, EventKind kind) {
    const Event* last = nullptr;
    for (const Event& e : recording.events)
        if (e.kind == kind) last = &e;
    return last;
}

double count_of(const sim::Recording& recording, std::initializer_list<EventKind> kinds) {
    double count = 0;
    for (const Event& e : recording.events)
        count += std::find(kinds.begin(), kinds.end(), e.kind) != kinds.end() ? 1 : 0;
    return count;
}

}  // namespace

void add_suture_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto& tools = recording.header.tools;
    if (std::none_of(tools.begin(), tools.end(), [](const sim::ToolSpec& tool) {
            return tool.kind == sim::ToolKind::kNeedleDriver;
        }))
        return;
    if (const Event* e = last_of(recording, EventKind::kBiteEntry))
        out.push_back({"bite_entry_offset_mm", 1e3 * static_cast<double>(e->value2)});
    if (const Event* e = last_of(recording, EventKind::kBiteExit))
        out.push_back({"bite_exit_offset_mm", 1e3 * static_cast<double>(e->value2)});
    // Those of the bite: a prick elsewhere, before it or after it, says nothing of it.
    if (const std::optional<Bite> bite = last_bite(recording)) {
        if (bite->left) out.push_back({"bite_depth_mm", 1e3 * bite->depth_m});
        out.push_back({"bite_angle_deg", bite->angle_rad * 180 / std::numbers::pi});
        // A row counts its own.
        if (bites_of(recording).empty()) out.push_back({"bites_done", bite->done ? 1.0 : 0.0});
    }
    out.push_back({"needle_entries", count_of(recording, {EventKind::kNeedleEntered})});
    out.push_back(
        {"needle_regrasps", std::max(0.0, count_of(recording, {EventKind::kNeedleTaken}) - 1)});
    out.push_back({"needle_slips",
                   count_of(recording, {EventKind::kNeedleSlipped, EventKind::kNeedleTurned})});
    out.push_back(
        {"thread_cuts", count_of(recording, {EventKind::kThreadCut, EventKind::kThreadToreOut})});
}

}  // namespace placode::assessment

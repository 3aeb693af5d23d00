// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/patch_metrics.h"

#include <algorithm>

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;

// Events hold floats: of 5 mm these are right to half a nanometre.
constexpr double kFloatM = 1e-9;

bool is_point(const Event& e) { return e.kind == EventKind::kPatchEdge && e.element >= 0; }

}  // namespace

const Event* least_overlap(const sim::Recording& recording) {
    const Event* least = nullptr;
    for (const Event& e : recording.events)
        if (is_point(e) && (least == nullptr || e.value < least->value)) least = &e;
    return least;
}

void add_patch_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const Event *head = nullptr, *fold = nullptr;
    double points = 0, enough = 0, sum_m = 0, grasps = 0;
    for (const Event& e : recording.events) {
        if (e.kind == EventKind::kPatchFold) fold = &e;
        if (e.kind == EventKind::kPatchEdge && e.element < 0) head = &e;
        grasps += e.kind == EventKind::kGrasped ? 1 : 0;
        if (!is_point(e)) continue;
        const auto overlap_m = static_cast<double>(e.value);
        ++points;
        enough += overlap_m >= kPatchOverlapM - kFloatM ? 1 : 0;
        sum_m += std::min(overlap_m, kPatchOverlapM);
    }
    const bool whole = head != nullptr && fold != nullptr && points > 0 &&
                       points == static_cast<double>(head->value) && fold->value2 > 0;
    if (!whole) return;
    out.push_back({"patch_overlap_percent", 100 * enough / points});
    out.push_back({"patch_overlap_mean_mm", 1e3 * sum_m / points});
    out.push_back(
        {"patch_overlap_least_mm", 1e3 * static_cast<double>(least_overlap(recording)->value)});
    out.push_back({"patch_uncovered_percent", 100 * static_cast<double>(head->value2)});
    out.push_back({"patch_folded_percent",
                   100 * static_cast<double>(fold->value) / static_cast<double>(fold->value2)});
    out.push_back({"patch_grasps", grasps});
}

}  // namespace placode::assessment

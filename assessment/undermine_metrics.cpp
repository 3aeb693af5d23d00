// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/undermine_metrics.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;

constexpr int32_t kLines = -1, kWanted = -3, kFreed = -4, kBeyond = -5;

const Event* end_event(const sim::Recording& recording, EventKind kind, int32_t element) {
    const Event* found = nullptr;
    for (const Event& e : recording.events)
        if (e.kind == kind && e.element == element) found = &e;
    return found;
}

double number(float value) { return static_cast<double>(value); }

double percent(float part, float whole) {
    return whole > 0 ? 100 * number(part) / number(whole) : 0;
}

}  // namespace

const Event* shallowest_line(const sim::Recording& recording, int side) {
    const Event* least = nullptr;
    for (const Event& e : recording.events) {
        if (e.kind != EventKind::kUndermined || e.element < 0) continue;
        if (side != 0 && (e.value2 > 0 ? 1 : -1) != side) continue;
        if (least == nullptr || e.value < least->value) least = &e;
    }
    return least;
}

void add_undermine_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const Event *head = end_event(recording, EventKind::kUndermined, kLines),
                *wanted = end_event(recording, EventKind::kUndermined, kWanted),
                *freed = end_event(recording, EventKind::kUndermined, kFreed),
                *beyond = end_event(recording, EventKind::kUndermined, kBeyond),
                *tension = end_event(recording, EventKind::kClosingTension, -1);
    if (head == nullptr || wanted == nullptr || freed == nullptr || beyond == nullptr ||
        tension == nullptr)
        return;
    double lines = 0, sum_m = 0, fascia_m3 = 0;
    for (const Event& e : recording.events) {
        if (e.kind == EventKind::kTorn && e.tissue == sim::Tissue::kMuscle)
            fascia_m3 += number(e.value);
        if (e.kind != EventKind::kUndermined || e.element < 0) continue;
        ++lines;
        sum_m += number(e.value);
    }
    if (lines == 0 || lines != number(head->value)) return;
    out.push_back({"undermine_left_percent", percent(freed->value, wanted->value)});
    out.push_back({"undermine_right_percent", percent(freed->value2, wanted->value2)});
    out.push_back({"undermine_depth_mm", 1e3 * sum_m / lines});
    out.push_back({"undermine_beyond_mm2", 1e6 * (number(beyond->value) + number(beyond->value2))});
    out.push_back({"undermine_fascia_mm3", 1e9 * fascia_m3});
    out.push_back({"closing_before_n_m", number(tension->value2)});
    out.push_back({"closing_after_n_m", number(tension->value)});
    if (tension->value2 > 0)
        out.push_back({"closing_percent", percent(tension->value, tension->value2)});
}

}  // namespace placode::assessment

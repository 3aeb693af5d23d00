// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/closure.h"

namespace placode::assessment {

const sim::Event* widest_gap(const sim::Recording& recording) {
    const sim::Event* widest = nullptr;
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kSlitGap || e.element < 0) continue;
        if (widest == nullptr || e.value > widest->value) widest = &e;
    }
    return widest;
}

void add_closure_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const sim::Event* widest = widest_gap(recording);
    if (widest == nullptr) return;
    double sum = 0, stations = 0, shut = 0;
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kSlitGap || e.element < 0) continue;
        sum += static_cast<double>(e.value);
        ++stations;
        shut += static_cast<double>(e.value) <= kShutM ? 1 : 0;
    }
    out.push_back({"slit_shut_percent", 100 * shut / stations});
    out.push_back({"slit_gap_mean_mm", 1e3 * sum / stations});
    out.push_back({"slit_gap_widest_mm", 1e3 * static_cast<double>(widest->value)});
}

}  // namespace placode::assessment

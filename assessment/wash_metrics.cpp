// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/wash_metrics.h"

namespace placode::assessment {

using sim::Event;
using sim::IrrigationSum;

const Event* irrigation_sum(const sim::Recording& recording, IrrigationSum what) {
    const Event* found = nullptr;
    for (const Event& e : recording.events)
        if (e.kind == sim::EventKind::kIrrigated && e.element == static_cast<int32_t>(what))
            found = &e;
    return found;
}

void add_wash_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const Event *jet = irrigation_sum(recording, IrrigationSum::kJet),
                *fluid = irrigation_sum(recording, IrrigationSum::kFluid),
                *view = irrigation_sum(recording, IrrigationSum::kView),
                *suction = irrigation_sum(recording, IrrigationSum::kSuction),
                *debris = irrigation_sum(recording, IrrigationSum::kDebris);
    if (jet == nullptr || fluid == nullptr || view == nullptr || suction == nullptr ||
        debris == nullptr)
        return;
    const auto number = [](float value) { return static_cast<double>(value); };
    out.push_back({"wash_jet_peak_pa", number(jet->value)});
    out.push_back({"wash_jet_over_s", number(jet->value2)});
    if (debris->value > 0)
        out.push_back(
            {"wash_cleared_percent", 100 * (1 - number(debris->value2) / number(debris->value))});
    out.push_back({"wash_fluid_left_mm3", 1e9 * number(fluid->value)});
    out.push_back({"wash_fluid_used_ml", 1e6 * number(fluid->value2)});
    out.push_back({"wash_hidden_percent", 100 * number(view->value)});
    out.push_back({"wash_blind_s", number(view->value2)});
    out.push_back({"wash_suction_held_s", number(suction->value)});
    out.push_back({"wash_suction_placode_s", number(suction->value2)});
}

}  // namespace placode::assessment

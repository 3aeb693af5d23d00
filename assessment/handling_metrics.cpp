// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/handling_metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;

constexpr double kDegrees = 180 / std::numbers::pi;

/// What a recording says of a needle in hands.
struct Handling {
    double handovers = 0, between = 0, drops = 0, turned_deg = 0;
    // The worst of each. Nothing happened is nothing bad: the steps say what was done.
    double askew_deg = 0, off_percent = 0, turn_deg = 0, force_mn = 0;

    static void raise(double& worst, double value) { worst = std::max(worst, value); }
    void add(const Event& e) {
        const auto value = static_cast<double>(e.value), value2 = static_cast<double>(e.value2);
        switch (e.kind) {
            case EventKind::kNeedleGrip:
                raise(askew_deg, std::acos(std::clamp(value2, 0.0, 1.0)) * kDegrees);
                break;
            case EventKind::kNeedlePlaced:
                raise(off_percent, 100 * value2);
                break;
            case EventKind::kNeedleHandedOver:
                if (e.element == 0) {
                    ++between;
                    break;
                }
                handovers += e.element > 0 ? 1 : 0;  // else the first one has kept it
                raise(turn_deg, 2 * std::asin(std::clamp(value, 0.0, 1.0)) * kDegrees);
                raise(force_mn, 1e3 * value2);
                break;
            case EventKind::kNeedleDropped:
                ++drops;
                break;
            case EventKind::kNeedleSwung:
                turned_deg += value * kDegrees;
                break;
            default:
                break;
        }
    }
};

}  // namespace

void add_handling_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto& tools = recording.header.tools;
    if (std::count_if(tools.begin(), tools.end(), [](const sim::ToolSpec& tool) {
            return tool.kind == sim::ToolKind::kNeedleDriver;
        }) < 2)
        return;
    Handling handling;
    for (const Event& event : recording.events) handling.add(event);
    out.push_back({"needle_handovers", handling.handovers});
    out.push_back({"needle_let_between", handling.between});
    out.push_back({"needle_drops", handling.drops});
    out.push_back({"needle_turned_deg", handling.turned_deg});
    out.push_back({"needle_askew_deg", handling.askew_deg});
    out.push_back({"needle_place_off_percent", handling.off_percent});
    out.push_back({"needle_handover_turn_deg", handling.turn_deg});
    out.push_back({"needle_handover_force_mn", handling.force_mn});
}

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/closure.h"

#include <cmath>
#include <vector>

#include "assessment/leak_map.h"
#include "assessment/loci.h"
#include "sim/contact/slit_flow.h"

namespace placode::assessment {
namespace {

double apart_m(const sim::Event& a, const sim::Event& b) {
    return (rest_place(a) - rest_place(b)).norm();
}

/// Of the whole slit; each station stands for half the way to either neighbour, and between a tip
/// and the station next to it nothing is counted.
double whole_leak_m3_s(const std::vector<const sim::Event*>& stations, double depth_m) {
    double sum = 0;
    for (size_t i = 0; i < stations.size(); ++i) {
        const sim::Event& here = *stations[i];
        double length_m = 0;
        if (i > 0) length_m += 0.5 * apart_m(here, *stations[i - 1]);
        if (i + 1 < stations.size()) length_m += 0.5 * apart_m(here, *stations[i + 1]);
        sum += leak_m3_s(
            {length_m, static_cast<double>(here.value2), static_cast<double>(here.value), depth_m});
    }
    return sum;
}

/// Where it leaks and where it burst.
void add_places(const sim::Recording& recording, std::vector<Metric>& out) {
    const std::optional<LeakMap> map = leak_map(recording);
    if (!map) return;
    if (const std::optional<LeakPlace> worst = worst_leak(*map, LeakStage::kGood)) {
        out.push_back({"slit_leak_worst_mm", 1e3 * worst->along_m});
        out.push_back({"slit_leak_worst_stretch", static_cast<double>(worst->stretch)});
    }
    if (!map->burst) return;
    if (const std::optional<LeakPlace> worst = worst_leak(*map, LeakStage::kLast))
        out.push_back({"slit_burst_mm", 1e3 * worst->along_m});
}

}  // namespace

double leak_m3_s(const LeakyGap& gap) {
    sim::SlitStretch stretch;
    stretch.length_m = gap.length_m;
    stretch.layers = 1;
    stretch.gap_m = {gap.mouth_m, gap.neck_m};
    stretch.depth_m = {0, gap.depth_m};
    return sim::flow_through(stretch, kLeakPa).flow_m3_s;
}

std::optional<Watertight> watertight_of(const sim::Recording& recording) {
    Watertight out;
    int wholes = 0;
    bool ended = false;
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kWatertight) continue;
        const auto value = static_cast<double>(e.value);
        if (e.element == -1) {
            (wholes == 0 ? out.pass_m3_s : out.good_m3_s) = value;
            ++wholes;
        } else if (e.element == -2) {
            out.held_pa = static_cast<double>(e.value2);
            ended = true;
        } else if (wholes == 1 && (out.worst == nullptr || e.value > out.worst->value)) {
            out.worst = &e;
        }
    }
    if (wholes != 2 || !ended) return std::nullopt;
    return out;
}

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
    std::vector<const sim::Event*> stations;
    double sum = 0, shut = 0, depth_m = 0;
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kSlitGap) continue;
        if (e.element < 0) {
            depth_m = static_cast<double>(e.value2);
            continue;
        }
        stations.push_back(&e);
        sum += static_cast<double>(e.value);
        shut += static_cast<double>(e.value) <= kShutM ? 1 : 0;
    }
    const auto count = static_cast<double>(stations.size());
    out.push_back({"slit_shut_percent", 100 * shut / count});
    out.push_back({"slit_gap_mean_mm", 1e3 * sum / count});
    out.push_back({"slit_gap_widest_mm", 1e3 * static_cast<double>(widest->value)});
    if (const std::optional<Watertight> test = watertight_of(recording)) {
        out.push_back({"slit_leak_6_ml_min", kMlMinPerM3S * test->pass_m3_s});
        out.push_back({"slit_leak_12_ml_min", kMlMinPerM3S * test->good_m3_s});
        // Rounded down: an open slit holds nothing, and not a hundredth.
        out.push_back({"slit_burst_cmh2o", std::floor(10 * test->held_pa / kPaPerCmH2O) / 10});
        add_places(recording, out);
    } else if (depth_m > 0)
        out.push_back({"slit_leak_ml_min", kMlMinPerM3S * whole_leak_m3_s(stations, depth_m)});
}

}  // namespace placode::assessment

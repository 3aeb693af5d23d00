// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/closure.h"

#include <cmath>
#include <vector>

#include "assessment/loci.h"

namespace placode::assessment {
namespace {

// Amniotic and cerebrospinal fluid at 37 C.
constexpr double kViscosityPaS = 0.7e-3, kDensityKgM3 = 1005;
constexpr double kDischarge = 0.6;  // of a sharp-edged orifice
constexpr double kMlMinPerM3S = 6e7;

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

}  // namespace

double leak_m3_s(const LeakyGap& gap) {
    const double w = gap.length_m, g0 = gap.mouth_m, g1 = gap.neck_m;
    if (!(w > 0 && g0 > 0 && g1 > 0)) return 0;
    // p = a Q^2 + b Q, solved without a difference of near numbers.
    const double area = kDischarge * w * g1;
    const double a = kDensityKgM3 / (2 * area * area);
    const double b = 12 * kViscosityPaS * gap.depth_m * (g0 + g1) / (2 * g0 * g0 * g1 * g1 * w);
    return 2 * kLeakPa / (b + std::sqrt(b * b + 4 * a * kLeakPa));
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
    if (depth_m > 0)
        out.push_back({"slit_leak_ml_min", kMlMinPerM3S * whole_leak_m3_s(stations, depth_m)});
}

}  // namespace placode::assessment

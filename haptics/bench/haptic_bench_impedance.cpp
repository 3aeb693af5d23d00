// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep of a machine against the wall, and what the port is at single frequencies.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "haptics/bench/haptic_bench_hand.h"

namespace placode::haptics {

namespace {

/// Force and displacement against the phase of the sweep, from one phase to another.
HapticBenchImpedance impedance_at(double hz, const HapticBenchResult& result, double from,
                                  double to) {
    std::complex<double> force = 0, moved = 0, turn_sum = 0;
    double mean_force = 0, mean_moved = 0, n = 0;
    for (size_t i = 1; i < result.force_n.size(); ++i) {
        const double phase = sweep_phase((static_cast<double>(i) + 0.5) * kHapticBenchTickS);
        if (phase < from || phase > to) continue;
        // A force is held for a tick: it belongs to the middle of the moved in it.
        const double x = 0.5 * (static_cast<double>(result.position_m[i - 1]) +
                                static_cast<double>(result.position_m[i]));
        const auto f = static_cast<double>(result.force_n[i]);
        const std::complex<double> turn = std::polar(1.0, -phase);
        moved += x * turn;
        force += f * turn;
        turn_sum += turn;
        mean_moved += x;
        mean_force += f;
        ++n;
    }
    moved -= mean_moved / n * turn_sum;
    force -= mean_force / n * turn_sum;
    const std::complex<double> ratio = force / moved;
    return {hz, std::abs(ratio), std::arg(ratio)};
}

}  // namespace

std::vector<HapticBenchImpedance> haptic_bench_impedance(HapticBenchCase what) {
    what.world = HapticBenchWorld::kWall;
    what.seconds = kSweepStartS + kSweepS;
    if (what.sweep_m <= 0) what.sweep_m = 0.001;
    const HapticBenchResult result = run_haptic_bench(what);
    std::vector<HapticBenchImpedance> out;
    const double rate = std::log(kSweepToHz / kSweepFromHz) / kSweepS;
    for (const double hz : {0.7, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0}) {
        // Whole turns of the sweep around the moment at which it passes this frequency.
        const double middle = sweep_phase(kSweepStartS + std::log(hz / kSweepFromHz) / rate);
        const double half = std::numbers::pi * std::max(1.0, std::round(hz));
        out.push_back(impedance_at(hz, result, middle - half, middle + half));
    }
    return out;
}

}  // namespace placode::haptics

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the benchmarks of the solver share: repeated runs on the wall clock, and the plain slab.

#include <array>
#include <functional>
#include <vector>

#include "sim/solver/soft_body.h"

namespace placode::bench {

/// How often and how long a benchmark measures.
struct Plan {
    int runs = 20;
    int substeps = 1000;  ///< A run.
};

/// Substeps a second over several runs.
struct Rates {
    double median = 0, slowest = 0, fastest = 0;
};

/// `run(substeps)` does that many substeps. One run before the clock starts warms caches and pages.
[[nodiscard]] Rates measure_rates(const Plan& plan, const std::function<void(int)>& run);

/// Cells of 1 mm, 5 kPa, held at both ends of x, h = 0.125 ms (Courant number 0.54), in RCM order.
[[nodiscard]] sim::SoftBody slab(sim::Method method, const std::array<int, 3>& cells_mm);

[[nodiscard]] const char* method_name(sim::Method method);

/// Slope of log(y) over log(x), least squares.
[[nodiscard]] double log_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace placode::bench

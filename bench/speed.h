// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Substeps a second of a task's field and of a plain slab, at one and two threads. Wall clock,
// median of several runs.

#include <functional>
#include <string>
#include <vector>

#include "bench/timing.h"

namespace placode::bench {

struct SpeedRow {
    std::string case_name, method;
    int vertices = 0, tets = 0, threads = 0, substeps_a_frame = 0;
    double per_second = 0, slowest = 0, fastest = 0;  ///< Substeps.
};

struct Speed {
    double field_build_s = 0;
    std::vector<SpeedRow> rows;
};

/// `measured` is told every row as it comes. Throws DefinitionError.
[[nodiscard]] Speed measure_speed(const std::string& task, const Plan& plan,
                                  const std::function<void(const SpeedRow&)>& measured);

}  // namespace placode::bench

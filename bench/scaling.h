// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cost, memory and building time against the number of tetrahedra, from 3,000 to 640,000, and of
// a task's field. One thread, wall clock.

#include <functional>
#include <string>
#include <vector>

namespace placode::bench {

struct ScalingRow {
    std::string case_name, method;
    int vertices = 0, tets = 0;
    double build_s = 0, bytes_a_tet = 0, per_second = 0;

    [[nodiscard]] double ns_a_tet() const { return 1e9 / (per_second * tets); }
};

/// Up to 151,200 tets when `quick`. `measured` is told every row as it comes. Throws
/// DefinitionError.
[[nodiscard]] std::vector<ScalingRow> measure_scaling(
    const std::string& task, bool quick, const std::function<void(const ScalingRow&)>& measured);

/// Cost of a substep ~ N^exponent over the slabs.
[[nodiscard]] double exponent(const std::vector<ScalingRow>& rows, const std::string& method);

}  // namespace placode::bench

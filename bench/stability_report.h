// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `placodectl bench stability` writes: a table, and the verdicts in Markdown.

#include <string>
#include <vector>

#include "bench/machine.h"
#include "sim/verify/stability_cases.h"

namespace placode::bench {

/// On what and how the cases were run.
struct StabilityRun {
    Machine machine;
    std::string length;  ///< What was run, and what the full length would be.
    int failed = 0;
    double wall_s = 0;
};

/// How long it took to be back, where that says something; else "".
[[nodiscard]] std::string recovery_text(const sim::StabilityResult& result);

[[nodiscard]] std::string stability_csv(const std::vector<sim::StabilityResult>& results);
[[nodiscard]] std::string stability_report(const std::vector<sim::StabilityResult>& results,
                                           const StabilityRun& run);

}  // namespace placode::bench

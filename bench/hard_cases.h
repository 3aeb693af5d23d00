// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hard cases in the fields of tasks, beside those of the bare solver
// (sim/verify/stability_cases.h): needle and thread, patch.

#include <string>
#include <vector>

#include "sim/verify/stability_cases.h"

namespace placode::bench {

/// Names of the cases, in order.
[[nodiscard]] std::vector<std::string> hard_case_names();

/// @throws std::invalid_argument for an unknown name, std::runtime_error when a scripted hand does
/// not come as far as the case begins.
[[nodiscard]] sim::StabilityResult run_hard_case(const std::string& name,
                                                 const sim::StabilityOptions& options);

}  // namespace placode::bench

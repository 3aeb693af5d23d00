// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hard cases for the patch, in the scene of the task that has one: it is folded and pushed through
// a hole in the tissue, and handled without sense.

#include <string>
#include <vector>

#include "sim/verify/stability_cases.h"

namespace placode::bench {

[[nodiscard]] std::vector<std::string> patch_case_names();

/// @throws std::invalid_argument for an unknown name.
[[nodiscard]] sim::StabilityResult run_patch_case(const std::string& name,
                                                  const sim::StabilityOptions& options);

}  // namespace placode::bench

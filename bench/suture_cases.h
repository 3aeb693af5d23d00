// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hard cases for needle and thread, in the scene of a task that has them: the scripted expert
// bites, then the hand does what no hand should.

#include <string>
#include <vector>

#include "sim/verify/stability_cases.h"

namespace placode::bench {

[[nodiscard]] std::vector<std::string> suture_case_names();

/// @throws std::invalid_argument for an unknown name, std::runtime_error when the expert does not
/// come as far as the case begins.
[[nodiscard]] sim::StabilityResult run_suture_case(const std::string& name,
                                                   const sim::StabilityOptions& options);

}  // namespace placode::bench

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// On what a benchmark ran: written down with every figure.

#include <string>

namespace placode::bench {

struct Machine {
    std::string processor, system, compiler, build, kernel_target;
    unsigned logical_cores = 0;
    double load_average_1min = 0;  ///< When this was asked.
};

[[nodiscard]] Machine this_machine();

}  // namespace placode::bench

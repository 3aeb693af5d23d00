// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Instruments that take turns at one port: the one that the hand does not hold waits outside.

#include <algorithm>
#include <vector>

#include "sim/core/tool.h"

namespace placode::sim {

[[nodiscard]] inline bool shares_hand(const std::vector<ToolSpec>& tools,
                                      const ToolSpec& spec) noexcept {
    return std::count_if(tools.begin(), tools.end(),
                         [&](const ToolSpec& each) { return each.hand == spec.hand; }) > 1;
}

}  // namespace placode::sim

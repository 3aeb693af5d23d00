// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strips of scores.

#include <string>
#include <vector>

#include "reports/figure.h"

namespace placode::reports {

/// As strip_figure(), on an axis from 0 to 100 points whatever the values are: those of a single
/// person say nothing of the range. @pre all values are points of 100.
[[nodiscard]] Figure points_figure(const std::string& id, const std::string& title,
                                   const std::string& axis, const std::vector<StripGroup>& groups,
                                   const ChartStyle& style);

}  // namespace placode::reports

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// 95 % intervals of a share and of a mean, for tables of small studies.

#include <optional>
#include <span>

#include "assessment/rank_tests.h"

namespace placode::assessment {

/// Wilson's score interval of `count` out of `n`, 95 %. Stays inside 0..1 and works for 0 and n.
/// @pre 0 <= count <= n, n > 0. Source: Wilson 1927; R: prop.test(count, n, correct = FALSE).
[[nodiscard]] Interval wilson_interval(int count, int n);

/// Student's interval of the mean, 95 %; nothing below two values. R: t.test(values)$conf.int.
[[nodiscard]] std::optional<Interval> mean_interval(std::span<const double> values);

/// Cliff's delta of group 1 against group 2 with DeLong's interval of the area behind it
/// (delta = 2 A - 1), 95 %.
struct CliffsDelta {
    double delta = 0;
    Interval ci95;
    bool separated = false;  ///< No overlap: DeLong's variance is 0 and the interval says nothing.
};
/// @pre both groups have at least 2 values; throws std::invalid_argument otherwise.
[[nodiscard]] CliffsDelta cliffs_delta(std::span<const double> group1,
                                       std::span<const double> group2);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How two hands work together.

#include <span>

namespace placode::assessment {

struct Bimanual {
    double pearson_r = 0;  ///< Of the two speed series, population moments; 0 when one is constant.
    double path_left = 0, path_right = 0;  ///< Sum of speed dt.
    double path_ratio = 0;                 ///< Left to right; 0 when the right hand rests.
    double balance = 0;                    ///< min / max of the two paths, 0..1.
    double both = 0, left_only = 0, right_only = 0, neither = 0;  ///< Share of samples moving.
};

/// @param threshold Speed above which a hand moves [unit of the speeds].
/// @pre The series are equally long, at least two samples.
/// Source: Hofstad et al. 2013 (correlation), as in PerkTutor.
[[nodiscard]] Bimanual bimanual_dexterity(std::span<const double> left,
                                          std::span<const double> right, double dt_s,
                                          double threshold);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Descriptive statistics of questionnaire answers. SD is the sample SD (n - 1), quantiles are
// type 7 (the default of R); both are said so wherever they are shown.

#include <optional>
#include <span>
#include <vector>

namespace placode::assessment {

/// One Likert item.
struct LikertSummary {
    int scale_min = 1, scale_max = 5;
    int n = 0;                               ///< Answered.
    int missing = 0;                         ///< Not answered, or not on the scale.
    std::vector<int> counts;                 ///< Per value, from scale_min to scale_max.
    std::optional<double> mean, sd, median;  ///< sd needs two answers.
    std::optional<double> sd_population;     ///< Divides by n.
    std::optional<double> lower_quartile, upper_quartile;              ///< Type 7.
    std::optional<double> lower_quartile_type6, upper_quartile_type6;  ///< As SPSS.
    std::optional<double> mad;           ///< Median of the distances from the median, not scaled.
    int top2 = 0;                        ///< Answers in the two highest values.
    std::optional<double> top2_percent;  ///< Answers in the two highest values / answered.
};

/// @pre scale_min < scale_max.
[[nodiscard]] LikertSummary summarise_likert(std::span<const std::optional<int>> answers,
                                             int scale_min = 1, int scale_max = 5);

/// Type 7 quantile, q in 0..1. @pre `sorted` ascending and not empty.
[[nodiscard]] double quantile(std::span<const double> sorted, double q);
/// Type 6 quantile (SPSS, Minitab). @pre as quantile().
[[nodiscard]] double quantile_type6(std::span<const double> sorted, double q);

/// In any order. @pre not empty.
[[nodiscard]] double median_of(std::span<const double> values);
[[nodiscard]] std::optional<double> mean_of(std::span<const double> values);
/// Sample SD (n - 1); nothing below two values.
[[nodiscard]] std::optional<double> sample_sd(std::span<const double> values);

}  // namespace placode::assessment

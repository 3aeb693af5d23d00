// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Does a score tell groups apart that are known to differ? Area under the ROC curve of experts
// against novices, and whether the group between them lies between.

#include <optional>
#include <span>

#include "assessment/rank_tests.h"

namespace placode::assessment {

/// An area with its 95 % interval.
struct Separation {
    double auc = 0.5;
    Interval ci95;
    /// Every one of the better group is above every one of the other: DeLong's variance is 0 there,
    /// and the interval is Clopper & Pearson's for as many of as many of the smaller group.
    bool perfect = false;
};

struct KnownGroups {
    int novices = 0, intermediates = 0, experts = 0;
    double novice_median = 0, expert_median = 0;
    std::optional<double> intermediate_median;
    Separation expert_novice;
    std::optional<Separation> expert_intermediate, intermediate_novice;
    /// The median of the group between lies between the medians of the others, ends included;
    /// absent without such a group.
    std::optional<bool> between;
};

/// Higher values speak for experts. @pre novices and experts are not empty; `intermediates` may be.
/// Throws std::invalid_argument otherwise.
[[nodiscard]] KnownGroups known_groups(std::span<const double> novices,
                                       std::span<const double> intermediates,
                                       std::span<const double> experts);

}  // namespace placode::assessment

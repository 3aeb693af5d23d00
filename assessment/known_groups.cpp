// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/known_groups.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "assessment/roc.h"
#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

Separation separation(std::span<const double> low, std::span<const double> high) {
    std::vector<double> values(low.begin(), low.end());
    values.insert(values.end(), high.begin(), high.end());
    std::vector<bool> better(low.size(), false);
    better.insert(better.end(), high.size(), true);
    const Roc curve = roc(values, better);
    Separation found;
    found.auc = curve.auc;
    found.ci95 = curve.delong_ci95;
    found.perfect = curve.auc >= 1;
    // n of n: the lower bound is the n-th root of 0.025.
    if (found.perfect)
        found.ci95 = {std::pow(0.025, 1.0 / static_cast<double>(std::min(low.size(), high.size()))),
                      1};
    return found;
}

}  // namespace

KnownGroups known_groups(std::span<const double> novices, std::span<const double> intermediates,
                         std::span<const double> experts) {
    if (novices.empty() || experts.empty())
        throw std::invalid_argument("known groups: " + std::to_string(novices.size()) +
                                    " novices and " + std::to_string(experts.size()) +
                                    " experts; at least one of each is needed");
    KnownGroups groups;
    groups.novices = static_cast<int>(novices.size());
    groups.intermediates = static_cast<int>(intermediates.size());
    groups.experts = static_cast<int>(experts.size());
    groups.novice_median = median_of(novices);
    groups.expert_median = median_of(experts);
    groups.expert_novice = separation(novices, experts);
    if (intermediates.empty()) return groups;
    const double middle = median_of(intermediates);
    groups.intermediate_median = middle;
    groups.expert_intermediate = separation(intermediates, experts);
    groups.intermediate_novice = separation(novices, intermediates);
    groups.between = middle >= groups.novice_median && middle <= groups.expert_median;
    return groups;
}

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Agreement needs a complete table. Raters seldom judge all the same attempts: which of them to
// take.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "assessment/reliability.h"

namespace placode::assessment {

/// Attempt to rater to value.
using RatingTable = std::map<int64_t, std::map<int64_t, double>>;

/// Attempts that the same raters have all judged.
struct RatingBlock {
    std::vector<int64_t> raters;  ///< (k), ascending.
    Scores scores;                ///< (n x k), by attempt; empty where there is no block.
};

/// The block of two or more raters with the most values; of those the one with more attempts, then
/// the one whose raters come first. All groups are looked at up to 12 raters; of more raters all
/// pairs, each with those added who leave the most attempts.
/// @param least_attempts of a block, at least 1.
[[nodiscard]] RatingBlock complete_block(const RatingTable& ratings, size_t least_attempts);

}  // namespace placode::assessment

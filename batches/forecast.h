// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a larger batch will take on so many workers, from what shards took here: a queue whose
// workers take the next shard when they are free, simulated with costs drawn from the measured ones
// (a bootstrap; Efron and Tibshirani, An Introduction to the Bootstrap, 1993).

#include <cstdint>
#include <vector>

#include "batches/costs.h"

namespace placode::batches {

struct ForecastOrder {
    std::vector<ShardCost> measured;  ///< At least one.
    int64_t items = 0;                ///< Of the batch to come, at least one.
    int shard_size = 1;               ///< Items in each of its shards.
    int workers = 1;
    double lost_share = 0;  ///< Of shards that are killed somewhere and begin anew [0, 0.9].
    uint64_t seed = 1;
};

struct Forecast {
    int64_t shards = 0;
    double mean_s = 0, low_s = 0, high_s = 0;  ///< Until the last shard; 5 and 95 % of the draws.
    double worker_s = 0;                       ///< Mean of what all workers spend together.
    int draws = 0;
};

/// The start of a worker is spread over its shard's items, so that a forecast for other shard sizes
/// is too dear for larger ones and too cheap for smaller ones. Throws std::invalid_argument.
[[nodiscard]] Forecast forecast(const ForecastOrder& order);

}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/forecast.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <stdexcept>

#include "sim/core/random.h"

namespace placode::batches {
namespace {

constexpr int64_t kMostShards = 20'000'000;  ///< Drawn for one forecast: some seconds.
constexpr int kMostDraws = 400, kFewestDraws = 5;

void check(const ForecastOrder& order) {
    const auto wrong = [](const char* what) { throw std::invalid_argument(what); };
    if (order.measured.empty()) wrong("nothing was measured yet");
    if (order.items < 1 || order.shard_size < 1) wrong("expected at least one item");
    if ((order.items - 1) / order.shard_size >= kMostShards)
        wrong("more than 20 million shards; choose larger ones");
    if (order.workers < 1) wrong("expected at least one worker");
    if (!(order.lost_share >= 0 && order.lost_share <= 0.9))
        wrong("the share of lost shards: expected 0 to 0.9");
}

/// What an item took in each measured shard.
std::vector<double> item_costs(const std::vector<ShardCost>& measured) {
    std::vector<double> costs;
    for (const ShardCost& cost : measured)
        costs.push_back(cost.wall_s / static_cast<double>(cost.items));
    return costs;
}

struct Draw {
    double end_s = 0, worker_s = 0;
};

class Queue {
 public:
    explicit Queue(const ForecastOrder& order)
        : order_(order), costs_(item_costs(order.measured)), random_(order.seed) {}

    [[nodiscard]] Draw run(int64_t shards) {
        Draw draw;
        const auto workers = static_cast<size_t>(std::min<int64_t>(order_.workers, shards));
        std::priority_queue<double, std::vector<double>, std::greater<>> free(
            std::greater<>(), std::vector<double>(workers, 0.0));
        for (int64_t shard = 0; shard < shards; ++shard) {
            const double took = cost(items_of(shard));
            const double end = free.top() + took;
            free.pop();
            free.push(end);
            draw.end_s = std::max(draw.end_s, end);
            draw.worker_s += took;
        }
        return draw;
    }

 private:
    [[nodiscard]] int64_t items_of(int64_t shard) const {
        return std::min<int64_t>(order_.shard_size, order_.items - shard * order_.shard_size);
    }
    /// With what was lost on the way: a killed shard has taken a part of its time for nothing.
    double cost(int64_t items) {
        const auto pick =
            static_cast<size_t>(random_.uniform() * static_cast<double>(costs_.size()));
        const double whole = costs_[pick] * static_cast<double>(items);
        double took = whole;
        while (order_.lost_share > 0 && random_.uniform() < order_.lost_share)
            took += whole * random_.uniform();
        return took;
    }

    const ForecastOrder& order_;
    std::vector<double> costs_;
    sim::SplitMix64 random_;
};

}  // namespace

Forecast forecast(const ForecastOrder& order) {
    check(order);
    Forecast result;
    result.shards = (order.items + order.shard_size - 1) / order.shard_size;
    result.draws = static_cast<int>(
        std::clamp<int64_t>(kMostShards / result.shards, kFewestDraws, kMostDraws));
    Queue queue(order);
    std::vector<double> ends;
    for (int i = 0; i < result.draws; ++i) {
        const Draw draw = queue.run(result.shards);
        ends.push_back(draw.end_s);
        result.worker_s += draw.worker_s / result.draws;
    }
    std::sort(ends.begin(), ends.end());
    const auto at = [&](double share) {
        return ends[static_cast<size_t>(std::lround(share * static_cast<double>(ends.size() - 1)))];
    };
    result.mean_s = std::accumulate(ends.begin(), ends.end(), 0.0) / result.draws;
    result.low_s = at(0.05);
    result.high_s = at(0.95);
    return result;
}

}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The queue of a batch against closed forms.

#include "batches/forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace placode::batches {
namespace THIS_TEST {

ForecastOrder order(std::vector<double> walls, int64_t items, int workers) {
    ForecastOrder made;
    for (size_t i = 0; i < walls.size(); ++i)
        made.measured.push_back({static_cast<int>(i), 1, walls[i]});
    made.items = items;
    made.workers = workers;
    return made;
}

/// Quantiles of the exponential distribution of mean 1.
std::vector<double> exponential() {
    constexpr int kMany = 2000;
    std::vector<double> costs;
    for (int i = 0; i < kMany; ++i) costs.push_back(-std::log((i + 0.5) / kMany));
    return costs;
}

TEST(Forecast, EqualShardsTakeWholeRounds) {
    for (const auto& [items, workers, rounds] :
         {std::tuple{100, 1, 100}, {100, 8, 13}, {8, 8, 1}, {9, 8, 2}, {3, 64, 1}}) {
        const Forecast found = forecast(order({2.5}, items, workers));
        EXPECT_DOUBLE_EQ(found.mean_s, 2.5 * rounds) << items << " by " << workers;
        EXPECT_DOUBLE_EQ(found.low_s, found.high_s);
        EXPECT_NEAR(found.worker_s, 2.5 * items, 1e-6);
    }
}

TEST(Forecast, OneWorkerTakesTheSum) {
    const Forecast found = forecast(order({1, 2, 6}, 3000, 1));
    EXPECT_NEAR(found.mean_s, 3000 * 3.0, 0.005 * 9000);
    EXPECT_NEAR(found.worker_s, found.mean_s, 1e-6);
}

TEST(Forecast, AShardForEachWorkerTakesTheLongest) {
    // Mean of the largest of n exponential times: 1 + 1/2 + ... + 1/n. 400 draws with a standard
    // deviation of 1.25 have a standard error of 0.063; three of them.
    double harmonic = 0;
    for (int n = 1; n <= 50; ++n) harmonic += 1.0 / n;
    EXPECT_NEAR(forecast(order(exponential(), 50, 50)).mean_s, harmonic, 0.19);
}

TEST(Forecast, ManyShardsShareTheWorkEvenly) {
    // The sum over k workers and at most the longest shard more.
    const Forecast found = forecast(order(exponential(), 10000, 16));
    EXPECT_GE(found.mean_s, 10000 / 16.0 * 0.99);
    EXPECT_LE(found.mean_s, 10000 / 16.0 + 10);
    EXPECT_LE(found.low_s, found.mean_s);
    EXPECT_GE(found.high_s, found.mean_s);
}

TEST(Forecast, LostShardsCostWhatTheyHadDone) {
    // Each shard is lost a geometric number of times, p / (1 - p) on average, half done each time.
    ForecastOrder lossy = order({1}, 20000, 1);
    lossy.lost_share = 0.25;
    EXPECT_NEAR(forecast(lossy).mean_s, 20000 * (1 + 0.5 * 0.25 / 0.75), 0.005 * 20000);
}

TEST(Forecast, ShardsOfSeveralItemsCostAsManyTimesMore) {
    ForecastOrder large = order({2}, 95, 1);
    large.measured[0].items = 4;  // half a second each
    large.shard_size = 10;
    const Forecast found = forecast(large);
    EXPECT_EQ(found.shards, 10);
    EXPECT_NEAR(found.mean_s, 95 * 0.5, 1e-9) << "the last shard is half a one";
}

TEST(Forecast, TenMillionItemsAreForecastAsWell) {
    ForecastOrder huge = order({1, 3}, 10'000'000, 1000);
    huge.shard_size = 100;
    const Forecast found = forecast(huge);
    EXPECT_EQ(found.shards, 100'000);
    EXPECT_NEAR(found.mean_s, 2.0 * 10'000'000 / 1000, 0.02 * 20000);
}

TEST(Forecast, RefusesWhatCannotBeForecast) {
    EXPECT_THROW((void)forecast(order({}, 1, 1)), std::invalid_argument);
    EXPECT_THROW((void)forecast(order({1}, 0, 1)), std::invalid_argument);
    EXPECT_THROW((void)forecast(order({1}, 1, 0)), std::invalid_argument);
    EXPECT_THROW((void)forecast(order({1}, 1'000'000'000, 8)), std::invalid_argument);
    ForecastOrder lossy = order({1}, 1, 1);
    for (const double share : {-0.1, 1.0, std::nan("")}) {
        lossy.lost_share = share;
        EXPECT_THROW((void)forecast(lossy), std::invalid_argument) << share;
    }
}

}  // namespace THIS_TEST
}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/environment_fixture.h"
#include "tests/few_threads.h"

namespace placode::environment {
namespace THIS_TEST {

constexpr size_t kMany = 3;

/// Environments of half a second, and room for what a step brings.
struct Group {
    explicit Group(Autoreset autoreset, int threads) : fields(std::make_shared<FieldCache>()) {
        EnvironmentOptions options = test::coarse();
        options.time_limit_s = 0.2;
        options.start_spread_m = 0.002;
        for (size_t i = 0; i < kMany; ++i) {
            own.push_back(std::make_unique<Environment>(fields, "touch_targets", options));
            list.push_back(own.back().get());
        }
        batch = std::make_unique<Batch>(list, autoreset, threads);
        size = list[0]->observation_names().size();
        observations.resize(kMany * size);
        finals.resize(kMany * size);
    }
    BatchOutput out() { return {observations, finals, rewards, terminated, truncated, success}; }
    void step(sim::SplitMix64& random) {
        std::vector<double> actions(kMany * list[0]->tools() * kActionSize);
        for (double& number : actions) number = random.uniform(-1, 1);
        batch->step(actions, 50, out());
    }

    std::shared_ptr<FieldCache> fields;
    std::vector<std::unique_ptr<Environment>> own;
    std::vector<Environment*> list;
    std::unique_ptr<Batch> batch;
    size_t size = 0;
    std::vector<double> observations, finals;
    std::array<double, kMany> rewards{};
    std::array<uint8_t, kMany> terminated{}, truncated{}, success{};
};

TEST(Batch, GivesTheSameWithAnyNumberOfThreads) {
    std::vector<std::vector<double>> all;
    for (const int threads : {1, 3}) {
        Group group(Autoreset::kSameStep, threads);
        group.batch->reset(std::array<uint64_t, kMany>{1, 2, 3}, group.observations);
        EXPECT_EQ(group.fields->built(), 1U);
        sim::SplitMix64 random(3);
        std::vector<double> seen = group.observations;
        for (int i = 0; i < 10; ++i) {
            group.step(random);
            seen.insert(seen.end(), group.observations.begin(), group.observations.end());
            seen.insert(seen.end(), group.rewards.begin(), group.rewards.end());
        }
        all.push_back(seen);
    }
    EXPECT_EQ(all[0], all[1]);
}

TEST(Batch, BeginsAgainInTheSameStepAndHandsOutTheLastObservation) {
    Group group(Autoreset::kSameStep, 2);
    group.batch->reset(std::array<uint64_t, kMany>{1, 2, 3}, group.observations);
    sim::SplitMix64 random(3);
    for (int i = 0; i < 4; ++i) group.step(random);  // 0.2 s: the limit
    for (size_t i = 0; i < kMany; ++i) {
        EXPECT_EQ(group.truncated[i], 1);
        EXPECT_EQ(group.terminated[i], 0);
        EXPECT_NEAR(group.finals[i * group.size], 0.2, 1e-9);  // time_s
        EXPECT_EQ(group.observations[i * group.size], 0);      // of the next attempt
        EXPECT_EQ(group.list[i]->seed(), i + 1 + kMany);
    }
}

TEST(Batch, BeginsAgainInTheNextStepWithoutAReward) {
    Group group(Autoreset::kNextStep, 2);
    group.batch->reset(std::array<uint64_t, kMany>{1, 2, 3}, group.observations);
    sim::SplitMix64 random(3);
    for (int i = 0; i < 4; ++i) group.step(random);
    EXPECT_EQ(group.truncated[0], 1);
    EXPECT_NEAR(group.observations[0], 0.2, 1e-9);
    group.step(random);
    EXPECT_EQ(group.truncated[0], 0);
    EXPECT_EQ(group.observations[0], 0);
    EXPECT_EQ(group.rewards[0], 0);
    group.step(random);
    EXPECT_NEAR(group.observations[0], 0.05, 1e-9);
}

TEST(Batch, SaysWhatIsWrongAndStaysUsable) {
    Group group(Autoreset::kDisabled, 2);
    std::vector<double> actions(kMany * group.list[0]->tools() * kActionSize, 0.0);
    EXPECT_THROW(group.batch->step(actions, 1, group.out()), EnvironmentError);  // no reset
    group.batch->reset(std::array<uint64_t, kMany>{1, 2, 3}, group.observations);
    EXPECT_THROW(group.batch->step({actions.data(), 5}, 1, group.out()), EnvironmentError);
    actions.back() = std::nan("");
    EXPECT_THROW(group.batch->step(actions, 1, group.out()), EnvironmentError);
    actions.back() = 0;
    EXPECT_NO_THROW(group.batch->step(actions, 1, group.out()));
    Environment other(group.fields, "trace_contour", test::coarse());
    EXPECT_THROW(Batch({group.list[0], &other}, Autoreset::kDisabled, 1), EnvironmentError);
    EXPECT_THROW(Batch({}, Autoreset::kDisabled, 1), EnvironmentError);
}

TEST(Batch, WhereNoThreadIsToBeHadThoseThatBeganAreEnded) {
    if (!test::kThreadsCanRunOut) GTEST_SKIP() << "not with a sanitizer";
    Environment one(std::make_shared<FieldCache>(), "touch_targets", test::coarse());
    const std::vector<Environment*> list(64, &one);
    EXPECT_EQ(test::with_few_threads([&] { const Batch batch(list, Autoreset::kDisabled, 64); }),
              "no thread");
}

}  // namespace THIS_TEST
}  // namespace placode::environment

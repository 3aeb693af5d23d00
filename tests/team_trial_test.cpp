// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The choice between a team of threads and the caller alone, with costs that the test makes up.

#include "sim/core/team_trial.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "sim/core/random.h"
#include "sim/core/workers.h"

namespace THIS_TEST {

using namespace placode::sim;
using std::chrono::microseconds;

/// Frames that cost so much either way; how many of the last `look` were done alone.
template <class Cost>
int frames_alone(TeamTrial& trial, int frames, int look, Cost&& cost) {
    int alone = 0;
    for (int i = 0; i < frames; ++i) {
        if (i >= frames - look && trial.alone()) ++alone;
        trial.done(cost(trial.alone(), i));
    }
    return alone;
}

constexpr int kPeriod = TeamTrial::kKeep + TeamTrial::kTrial;
// Of a period: what a trial spends on the way that is not kept.
constexpr int kTried = TeamTrial::kTrial / 2;

TEST(TeamTrial, KeepsTheTeamWhereItPays) {
    TeamTrial trial;
    const auto cost = [](bool alone, int) { return microseconds(alone ? 900 : 560); };
    EXPECT_FALSE(trial.alone()) << "the team comes first";
    EXPECT_EQ(frames_alone(trial, 3 * kPeriod, kPeriod, cost), kTried);
}

TEST(TeamTrial, SendsItAwayWhereItDoesNotAndBringsItBack) {
    TeamTrial trial;
    const auto dear = [](bool alone, int) { return microseconds(alone ? 540 : 704); };
    EXPECT_EQ(frames_alone(trial, 3 * kPeriod, kPeriod, dear), kPeriod - kTried);
    const auto cheap = [](bool alone, int) { return microseconds(alone ? 704 : 540); };
    EXPECT_EQ(frames_alone(trial, 3 * kPeriod, kPeriod, cheap), kTried);
}

TEST(TeamTrial, ChangesNothingForAGainThatNobodyNotices) {
    TeamTrial trial;
    const auto cost = [](bool alone, int) { return microseconds(alone ? 970 : 1000); };
    EXPECT_EQ(frames_alone(trial, 3 * kPeriod, kPeriod, cost), kTried);
    const auto dear = [](bool alone, int) { return microseconds(alone ? 500 : 1000); };
    (void)frames_alone(trial, 2 * kPeriod, 1, dear);
    const auto back = [](bool alone, int) { return microseconds(alone ? 1000 : 970); };
    EXPECT_EQ(frames_alone(trial, 3 * kPeriod, kPeriod, back), kPeriod - kTried);
}

TEST(TeamTrial, IsNotMisledByFramesThatLostTheirCore) {
    TeamTrial trial;
    SplitMix64 random(7);
    // Every fifth frame costs a time slice more, whoever does it.
    const auto cost = [&](bool alone, int) {
        return microseconds((alone ? 540 : 704) + (random.uniform() < 0.2 ? 4000 : 0));
    };
    (void)frames_alone(trial, kPeriod, 1, cost);
    int alone = 0;
    for (int i = 0; i < 20; ++i) alone += frames_alone(trial, kPeriod, kPeriod, cost);
    EXPECT_GT(alone, 20 * kPeriod * 9 / 10);
}

TEST(TeamTrial, CountsOnlyFramesThatHaveJobsToShare) {
    Workers workers(2);
    for (int i = 0; i < 2 * kPeriod; ++i) const Workers::Frame idle(workers);
    EXPECT_FALSE(workers.alone());
    int64_t sum = 0;
    const auto body = [](void* of, int) noexcept { ++*static_cast<int64_t*>(of); };
    for (int i = 0; i < 100; ++i) {
        const Workers::Frame frame(workers);
        workers.run(1, body, &sum);  // one job is nobody else's
    }
    EXPECT_EQ(sum, 100);
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/workers.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

#include "tests/few_threads.h"

using placode::sim::Workers;

namespace THIS_TEST {

struct Counting {
    std::array<std::atomic<int>, 8> calls{};
    std::atomic<int> others{0};
    std::thread::id caller = std::this_thread::get_id();
};

void count(void* context, int job) noexcept {
    auto& c = *static_cast<Counting*>(context);
    c.calls[static_cast<size_t>(job)].fetch_add(1);
    if (std::this_thread::get_id() != c.caller) c.others.fetch_add(1);
    std::this_thread::sleep_for(std::chrono::microseconds(200));  // long enough to share
}

TEST(Workers, DoesEveryJobOnceAndSharesThem) {
    for (int threads = 1; threads <= 8; ++threads) {
        Workers workers(threads, Workers::Team::kFixed);
        EXPECT_EQ(workers.threads(), threads);
        Counting c;
        for (int round = 0; round < 50; ++round) workers.run(8, count, &c);
        for (const auto& calls : c.calls) EXPECT_EQ(calls.load(), 50);
        EXPECT_EQ(c.others.load() > 0, threads > 1);
    }
}

TEST(Workers, WhereNoThreadIsToBeHadThoseThatBeganAreEnded) {
    if (!placode::test::kThreadsCanRunOut) GTEST_SKIP() << "not with a sanitizer";
    EXPECT_EQ(placode::test::with_few_threads([] { const Workers workers(64); }), "no thread");
}

TEST(Workers, FewerThanOneThreadMeansTheCallerAlone) {
    Workers workers(0);
    EXPECT_EQ(workers.threads(), 1);
    EXPECT_TRUE(workers.alone());
}

TEST(Workers, EachRunSeesWhatTheRunsBeforeItHaveWritten) {
    struct Relay {
        std::array<int, 16> place{};  // plain ints: the runs must order them
        int step = 0;
        std::atomic<int> wrong{0};
    };
    for (int threads : {2, 3, 4}) {
        Workers workers(threads, Workers::Team::kFixed);
        Relay relay;
        for (relay.step = 1; relay.step <= 20000; ++relay.step) {
            workers.run(
                16,
                [](void* context, int job) noexcept {
                    auto& r = *static_cast<Relay*>(context);
                    // Written by whoever did the neighbour's job in the run before.
                    const auto own = static_cast<size_t>(job);
                    if (r.place[own] != r.step - 1) ++r.wrong;
                    r.place[own] = r.step;
                },
                &relay);
            if (relay.place[15] != relay.step) ++relay.wrong;
        }
        EXPECT_EQ(relay.wrong.load(), 0) << threads;
    }
}

TEST(Workers, WakesUpAgainAfterSleeping) {
    Workers workers(2, Workers::Team::kFixed);
    Counting c;
    for (int round = 0; round < 3; ++round) {
        workers.run(8, count, &c);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // far beyond the spinning
    }
    EXPECT_EQ(c.calls[7].load(), 3);
}

TEST(Workers, AThreadWithoutACoreSendsTheTeamAwayForAWhile) {
    struct Job {
        std::thread::id caller = std::this_thread::get_id();
        std::atomic<bool> late{true};
        std::atomic<int> by_others{0};
    };
    Workers workers(2);
    Job job;
    const auto body = [](void* context, int) noexcept {
        auto& j = *static_cast<Job*>(context);
        if (std::this_thread::get_id() == j.caller) {
            std::this_thread::sleep_for(std::chrono::microseconds(100));  // let the other begin
            return;
        }
        ++j.by_others;
        // As if it had lost its core in the middle of a job.
        if (j.late) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    };
    // On a busy machine the caller too may lose its core, until the time alone is over: try again.
    bool alone = false;
    for (int i = 0; i < 1000 && !alone; ++i) {
        job.late = true;
        const int64_t before = workers.stalls();
        for (int k = 0; k < 1000 && workers.stalls() == before; ++k) workers.run(4, body, &job);
        job.late = false;
        job.by_others = 0;
        workers.run(4, body, &job);
        alone = workers.alone() && job.by_others == 0;
    }
    EXPECT_TRUE(alone) << "the caller works alone after a stall";
    for (int k = 0; k < 100000 && job.by_others == 0; ++k) workers.run(4, body, &job);
    EXPECT_GT(job.by_others, 0) << "the team never came back";
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/workers.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

using placode::sim::Workers;

namespace {

struct Counting {
    std::array<std::atomic<int>, 8> calls{};
    std::array<std::thread::id, 8> thread{};
};

void count(void* context, int part) noexcept {
    auto& c = *static_cast<Counting*>(context);
    c.calls[static_cast<size_t>(part)].fetch_add(1);
    c.thread[static_cast<size_t>(part)] = std::this_thread::get_id();
}

}  // namespace

TEST(Workers, RunsEveryPartOnceAndPartZeroOnTheCaller) {
    for (int threads = 1; threads <= 8; ++threads) {
        Workers workers(threads, Workers::Team::kFixed);
        EXPECT_EQ(workers.threads(), threads);
        Counting c;
        for (int round = 0; round < 50; ++round) workers.run(count, &c);
        for (int part = 0; part < 8; ++part) {
            EXPECT_EQ(c.calls[static_cast<size_t>(part)].load(), part < threads ? 50 : 0);
        }
        EXPECT_EQ(c.thread[0], std::this_thread::get_id());
        if (threads > 1) {
            EXPECT_NE(c.thread[1], std::this_thread::get_id());
        }
    }
}

TEST(Workers, FewerThanOneThreadMeansTheCallerAlone) {
    Workers workers(0);
    EXPECT_EQ(workers.threads(), 1);
}

TEST(Workers, NobodyPassesABarrierBeforeAllHaveArrived) {
    struct Race {
        Workers* workers;
        std::array<int, 8> place{};  // plain ints: the barrier must order them
        std::atomic<int> wrong{0};
    };
    for (int threads : {2, 3, 4}) {
        Workers workers(threads, Workers::Team::kFixed);
        Race race{&workers, {}, {}};
        workers.run(
            [](void* context, int part) noexcept {
                auto& r = *static_cast<Race*>(context);
                for (int step = 1; step <= 200; ++step) {
                    r.place[static_cast<size_t>(part)] = step;
                    r.workers->barrier();
                    for (int other = 0; other < r.workers->threads(); ++other) {
                        if (r.place[static_cast<size_t>(other)] != step) ++r.wrong;
                    }
                    r.workers->barrier();
                }
            },
            &race);
        EXPECT_EQ(race.wrong.load(), 0) << threads;
    }
}

TEST(Workers, WakesUpAgainAfterSleeping) {
    Workers workers(2, Workers::Team::kFixed);
    Counting c;
    for (int round = 0; round < 3; ++round) {
        workers.run(count, &c);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // far beyond the spinning
    }
    EXPECT_EQ(c.calls[1].load(), 3);
}

TEST(Workers, AMemberWithoutACoreSendsTheTeamAwayForAWhile) {
    struct Job {
        Workers* workers;
        bool late = false;
        std::atomic<int> parts{0};
    };
    Workers workers(2);
    Job job{&workers, true, {}};
    const auto body = [](void* context, int part) noexcept {
        auto& j = *static_cast<Job*>(context);
        // As if the second thread had lost its core for longer than a time slice.
        if (part == 1 && j.late) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        j.workers->barrier();
        ++j.parts;
    };
    // On a busy machine the caller too may lose its core, until the time alone is over: try again.
    bool alone = false;
    for (int i = 0; i < 100 && !alone; ++i) {
        job.late = true;
        const int64_t before = workers.stalls();
        for (int k = 0; k < 1000 && workers.stalls() == before; ++k) {
            workers.run(body, &job);
            if (workers.parts() == 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        job.late = false;
        job.parts = 0;
        workers.run(body, &job);
        alone = job.parts == 1 && workers.parts() == 1;
    }
    EXPECT_TRUE(alone) << "the caller works alone after a stall";
    int rounds = 0;
    for (; workers.parts() == 1 && rounds < 10000; ++rounds) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        workers.run(body, &job);
    }
    EXPECT_EQ(workers.parts(), 2) << "the team never came back";
}

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks one after the other, in bounded memory, and none that outlives its program.
#include "ui/web/review_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "tests/attempt_fixture.h"

namespace placode::web {
namespace THIS_TEST {

using Stage = ReviewMaker::Stage;

ReviewMaker::Standing until_made(ReviewMaker& maker, const std::string& key) {
    for (;;) {
        const auto standing = maker.of(key);
        if (standing.stage != Stage::kWaiting && standing.stage != Stage::kMaking) return standing;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

const auto kQuiet = [](const std::string&) {};

TEST(ReviewMaker, MakesATrackOnceAndKeepsIt) {
    ReviewMaker maker(kReviewBytes, kQuiet);
    int read = 0;
    const auto recording = test::scripted_seconds("touch_targets", 1);
    const auto ask = [&] {
        return maker.ask("one", [&] {
            ++read;
            return recording;
        });
    };
    EXPECT_EQ(maker.of("one").stage, Stage::kBusy) << "nobody asked for it yet";
    EXPECT_NE(ask().stage, Stage::kBusy);
    const auto made = until_made(maker, "one");
    ASSERT_EQ(made.stage, Stage::kReady);
    EXPECT_TRUE(made.track->identical);
    EXPECT_EQ(ask().track, made.track);
    EXPECT_EQ(read, 1);
}

TEST(ReviewMaker, KeepsToItsMemoryAndDropsWhatWasSeenLongestAgo) {
    const auto recording = test::scripted_seconds("touch_targets", 1);
    size_t one = 0;
    {
        ReviewMaker maker(kReviewBytes, kQuiet);
        (void)maker.ask("size", [&] { return recording; });
        one = until_made(maker, "size").track->bytes();
    }
    ReviewMaker maker(2 * one + one / 2, kQuiet);
    for (const char* key : {"a", "b", "c"}) {
        (void)maker.ask(key, [&] { return recording; });
        ASSERT_EQ(until_made(maker, key).stage, Stage::kReady);
        (void)maker.of("a");  // a look at it keeps it
    }
    EXPECT_EQ(maker.of("b").stage, Stage::kBusy) << "it went";
    EXPECT_EQ(maker.of("a").stage, Stage::kReady);
    EXPECT_EQ(maker.of("c").stage, Stage::kReady);
    ReviewMaker small(1, kQuiet);
    (void)small.ask("large", [&] { return recording; });
    EXPECT_EQ(until_made(small, "large").stage, Stage::kReady) << "one is shown, however large";
}

TEST(ReviewMaker, TakesNoMoreThanItCanHoldAndStopsAtOnce) {
    const auto recording = test::scripted_seconds("touch_targets", 20);
    const auto before = std::chrono::steady_clock::now();
    {
        ReviewMaker maker(kReviewBytes, kQuiet);
        for (size_t i = 0; i < kMostReviewsWaiting; ++i)
            EXPECT_NE(maker.ask(std::to_string(i), [&] { return recording; }).stage, Stage::kBusy);
        bool read = false;
        EXPECT_EQ(maker
                      .ask("one more",
                           [&] {
                               read = true;
                               return recording;
                           })
                      .stage,
                  Stage::kBusy);
        EXPECT_FALSE(read) << "what is not taken need not be read";
    }
    // To simulate all of it takes longer than this, and a frame ends within milliseconds.
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(60));
}

// Eight pages at once, of the same attempt and of others: each recording may be 1 GiB in memory.
TEST(ReviewMaker, ReadsOneRecordingAtATimeAndNoneTwice) {
    const auto recording = test::scripted_seconds("touch_targets", 1);
    ReviewMaker maker(kReviewBytes, kQuiet);
    std::atomic<int> reading{0}, together{0}, reads{0};
    const auto ask_from_eight = [&](const std::function<std::string(int)>& key) {
        std::barrier at_once(8);
        std::vector<std::jthread> pages;  // joined before what they wait at is gone
        for (int i = 0; i < 8; ++i)
            pages.emplace_back([&, i] {
                at_once.arrive_and_wait();
                (void)maker.ask(key(i), [&] {
                    together = std::max(together.load(), ++reading);
                    ++reads;
                    std::this_thread::sleep_for(std::chrono::milliseconds(100));
                    --reading;
                    return recording;
                });
            });
    };
    ask_from_eight([](int) { return std::string("same"); });
    EXPECT_EQ(reads, 1);
    EXPECT_EQ(until_made(maker, "same").stage, Stage::kReady);
    ask_from_eight([](int i) { return "other " + std::to_string(i); });
    EXPECT_GE(reads, 2) << "one of them";
    EXPECT_LE(reads, 1 + static_cast<int>(kMostReviewsWaiting));
    EXPECT_EQ(together, 1);
}

// What is read has its place among those that wait, before it is there.
TEST(ReviewMaker, WhatIsReadWaitsAlready) {
    const auto recording = test::scripted_seconds("touch_targets", 1);
    ReviewMaker maker(kReviewBytes, kQuiet);
    (void)maker.ask("one", [&] {
        EXPECT_EQ(maker.of("one").stage, Stage::kReading);
        EXPECT_EQ(maker.ask("one", [&] { return recording; }).stage, Stage::kReading);
        EXPECT_EQ(maker.ask("two", [&] { return recording; }).stage, Stage::kBusy);
        return recording;
    });
    EXPECT_EQ(until_made(maker, "one").stage, Stage::kReady);
    EXPECT_EQ(maker.of("two").stage, Stage::kBusy) << "it was not taken";
}

TEST(ReviewMaker, SaysWhatCannotBeMadeAndGoesOn) {
    std::string logged;
    std::mutex mutex;
    ReviewMaker maker(kReviewBytes, [&](const std::string& line) {
        const std::lock_guard lock(mutex);
        logged += line;
    });
    auto broken = test::scripted_seconds("touch_targets", 1);
    broken.header.task_json = "{}";
    (void)maker.ask("broken", [&] { return broken; });
    EXPECT_EQ(until_made(maker, "broken").stage, Stage::kFailed);
    EXPECT_NE(logged.find("review of broken"), std::string::npos) << logged;
    EXPECT_THROW((void)maker.ask("none", []() -> sim::Recording { throw std::bad_alloc(); }),
                 std::bad_alloc);
    EXPECT_EQ(maker.of("none").stage, Stage::kBusy) << "as if nobody had asked for it";
    (void)maker.ask("good", [&] { return test::scripted_seconds("touch_targets", 1); });
    EXPECT_EQ(until_made(maker, "good").stage, Stage::kReady);
}

}  // namespace THIS_TEST
}  // namespace placode::web

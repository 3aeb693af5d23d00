// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/picture_pace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace placode::ui {
namespace THIS_TEST {

using std::chrono::milliseconds;
using testing::HasSubstr;

class Quality final : public PictureQuality {
 public:
    explicit Quality(bool software) : software_(software) {}
    bool simplify() override { return steps > 0 && steps-- > 0; }
    bool enrich() override { return steps < 3 && ++steps > 0; }
    [[nodiscard]] bool software() const override { return software_; }
    int steps = 3;

 private:
    bool software_;
};

curriculum::AttemptStatus status(double real_time, double pictures_hz) {
    curriculum::AttemptStatus s;
    s.time_s = 6;
    s.physics_hz = 1000 * real_time;
    s.real_time_now = real_time;
    s.pictures_now_hz = pictures_hz;
    return s;
}

TEST(PicturePace, ThePictureGivesWayBeforeTheSubsteps) {
    Quality quality(true);
    PicturePace pace(quality);
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    EXPECT_FALSE(pace.may_save_substeps());
    for (int left = 2; left >= 0; --left) {
        pace.watch(status(0.8, 30), now += milliseconds(600));
        EXPECT_EQ(quality.steps, left);
        EXPECT_FALSE(pace.may_save_substeps());
    }
    pace.watch(status(0.8, 30), now += milliseconds(600));
    EXPECT_TRUE(pace.may_save_substeps());
    EXPECT_THAT(pace.take_note(), HasSubstr("made simpler"));
    EXPECT_EQ(pace.take_note(), "");
}

TEST(PicturePace, AGraphicsCardDoesNotCompeteWithThePhysics) {
    Quality quality(false);
    PicturePace pace(quality);
    EXPECT_TRUE(pace.may_save_substeps());
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    pace.watch(status(0.8, 60), now);
    EXPECT_EQ(quality.steps, 3);
    pace.watch(status(1.0, 12), now += milliseconds(600));  // but it may be slow itself
    EXPECT_EQ(quality.steps, 2);
}

TEST(PicturePace, WhatWillNotCountIsSaidOnceASpell) {
    Quality quality(true);
    quality.steps = 0;
    PicturePace pace(quality);
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    curriculum::AttemptStatus slow = status(0.7, 6);
    slow.counts_not = true;
    EXPECT_TRUE(PicturePace::will_not_count(slow));
    slow.time_s = 2;
    EXPECT_FALSE(PicturePace::will_not_count(slow))
        << "one slow second at the start decides nothing";
    slow.time_s = 6;
    pace.watch(slow, now);
    EXPECT_THAT(pace.take_note(), HasSubstr("will not count"));
    pace.watch(slow, now += milliseconds(600));
    EXPECT_EQ(pace.take_note(), "");
    pace.watch(status(1, 30), now += milliseconds(600));
    pace.watch(slow, now += milliseconds(600));
    EXPECT_THAT(pace.take_note(), HasSubstr("will not count"));
}

TEST(PicturePace, PicturesThatAreTooDearAreMadeSimplerBeforeTheAttemptBegins) {
    Quality quality(true);
    PicturePace pace(quality);
    curriculum::AttemptStatus waiting = status(1, 0);
    waiting.waiting = true;
    waiting.time_s = 0;
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    const auto pictures = [&](int count, milliseconds cost) {
        for (int i = 0; i < count; ++i) {
            pace.drawn(now, now + cost);
            while (!pace.due(now)) now += milliseconds(1);
            pace.watch(waiting, now);
        }
    };
    pictures(3, milliseconds(500));  // shaders are compiled
    EXPECT_EQ(quality.steps, 3);
    pictures(9, milliseconds(40));
    EXPECT_EQ(quality.steps, 2);
    EXPECT_THAT(pace.take_note(), HasSubstr("made simpler"));
    pictures(100, milliseconds(30));
    EXPECT_EQ(quality.steps, 2);
}

TEST(PicturePace, ASlowStartDoesNotMakeTheWholeAttemptPlain) {
    Quality quality(true);
    PicturePace pace(quality);
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    const auto seconds = [&](int count, milliseconds cost) {
        for (const auto end = now + std::chrono::seconds(count); now < end;) {
            pace.drawn(now, now + cost);
            while (!pace.due(now)) now += milliseconds(1);
            pace.watch(status(1, 30), now);
        }
    };
    seconds(3, milliseconds(60));
    EXPECT_EQ(quality.steps, 0);
    seconds(3, milliseconds(10));
    EXPECT_EQ(quality.steps, 0) << "not at the first quiet moment";
    seconds(20, milliseconds(10));
    EXPECT_EQ(quality.steps, 3) << "one step after the other, to where it began";
    // What costs half of what is affordable stays: the next step may cost twice as much.
    seconds(2, milliseconds(60));
    const int left = quality.steps;
    seconds(20, milliseconds(20));
    EXPECT_EQ(quality.steps, left);
}

TEST(PicturePace, WhatWasGivenBackInVainIsNotGivenBackAgain) {
    Quality quality(true);
    quality.steps = 1;
    PicturePace pace(quality);
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    int changes = 0;
    for (int i = 0, before = 1; i < 3000; ++i) {  // at two steps a picture is too dear
        const milliseconds cost(quality.steps < 2 ? 12 : 40);
        pace.drawn(now, now + cost);
        while (!pace.due(now)) now += milliseconds(1);
        pace.watch(status(1, 30), now);
        changes += quality.steps != before ? 1 : 0;
        before = quality.steps;
    }
    EXPECT_EQ(changes, 2) << "one step up, and back for good";
    EXPECT_EQ(quality.steps, 1);
}

TEST(PicturePace, WhereTheProcessorDrawsThePhysicsGetsMoreOfItWhileItIsLate) {
    Quality quality(true);
    PicturePace pace(quality);
    PicturePace::Clock::time_point now{};
    now += std::chrono::hours(1);
    pace.watch(status(1.0, 30), now);
    pace.drawn(now, now + milliseconds(30));
    EXPECT_TRUE(pace.due(now + milliseconds(42)));
    pace.watch(status(0.9, 30), now += milliseconds(600));
    pace.drawn(now, now + milliseconds(30));
    EXPECT_FALSE(pace.due(now + milliseconds(59)));
    EXPECT_TRUE(pace.due(now + milliseconds(60)));
}

TEST(PicturePace, NothingHappensWhileNobodyHasBegun) {
    Quality quality(true);
    PicturePace pace(quality);
    curriculum::AttemptStatus waiting = status(0.1, 1);
    waiting.waiting = true;
    pace.watch(waiting, PicturePace::Clock::time_point{} + std::chrono::hours(1));
    EXPECT_EQ(quality.steps, 3);
}

}  // namespace THIS_TEST
}  // namespace placode::ui

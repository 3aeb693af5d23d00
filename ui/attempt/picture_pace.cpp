// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/picture_pace.h"

#include <algorithm>
#include <utility>

#include "curriculum/machine_speed.h"

namespace placode::ui {

namespace {

using std::chrono::milliseconds;

constexpr auto kScreen = milliseconds(16);    // no screen shows more
constexpr auto kSoftware = milliseconds(33);  // where the processor draws
constexpr auto kLookEvery = milliseconds(500);
constexpr double kRoom = 1.02;  // of real time: below it the physics needs more of the processor

}  // namespace

void PicturePace::drawn(Clock::time_point start, Clock::time_point end) {
    if (!quality_.software()) {
        next_ = std::max(start + kScreen, end);
        return;
    }
    // The physics shares the processor: a picture in 33 ms, and at most half of the time for them;
    // where even that is slow, `watch` makes them simpler.
    next_ = std::max(start + kSoftware, end + (end - start));
}

void PicturePace::watch(const curriculum::AttemptStatus& status, Clock::time_point now) {
    if (status.waiting || status.time_s <= 0 || now - looked_ < kLookEvery) return;
    looked_ = now;
    const bool late = status.physics_hz > 0 && status.real_time_now < 1 / kRoom;
    const bool few =
        status.pictures_now_hz > 0 && status.pictures_now_hz < 1.1 * curriculum::kLeastPicturesHz;
    if ((late && quality_.software()) || few) {
        simplest_ = !quality_.simplify();
        if (!simplest_ && !std::exchange(told_simple_, true))
            note_ = "This computer is slow: the picture was made simpler";
    }
    if (status.slow && status.counts_not && !std::exchange(told_slow_, true))
        note_ = "This computer is too slow: the attempt will not count";
    if (!status.slow) told_slow_ = false;
}

std::string PicturePace::take_note() { return std::exchange(note_, {}); }

}  // namespace placode::ui

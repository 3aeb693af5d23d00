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
// Where the processor draws, the physics shares it: it rests after a picture for that share of
// what the picture took, longer while the physics is late.
constexpr double kRest = 0.4, kLateRest = 1.0;
// Gives the least pictures a second, with a tenth to spare.
constexpr double kAffordableMs = 1000 / (1.1 * (1 + kRest) * curriculum::kLeastPicturesHz);
// Where a picture takes no more than this share of that, and has for a while, one step of what was
// taken is given back: a slow start must not make the whole attempt plain. Once.
constexpr double kCheap = 0.5;
constexpr auto kSteady = std::chrono::seconds(4), kTrial = std::chrono::seconds(10);
constexpr int kSettlingPictures = 4;  // the first compile shaders and fill caches
constexpr double kSpeedKnownS = 5;    // of an attempt; before it one slow second decides
constexpr double kRoom = 1.02;  // of real time: below it the physics needs more of the processor

}  // namespace

void PicturePace::drawn(Clock::time_point start, Clock::time_point end) {
    if (!quality_.software()) {
        next_ = std::max(start + kScreen, end);
        return;
    }
    const std::chrono::duration<double, std::milli> cost = end - start;
    if (++pictures_ > kSettlingPictures)
        cost_ = pictures_ == kSettlingPictures + 1 ? cost : 0.7 * cost_ + 0.3 * cost;
    // Where even that is slow, `watch` makes them simpler.
    const double rest = late_ ? kLateRest : kRest;
    next_ =
        std::max(start + kSoftware, end + std::chrono::duration_cast<Clock::duration>(rest * cost));
}

void PicturePace::watch(const curriculum::AttemptStatus& status, Clock::time_point now) {
    if (now - looked_ < kLookEvery) return;
    looked_ = now;
    const bool dear = quality_.software() && cost_.count() > kAffordableMs;
    if (status.waiting || status.time_s <= 0) {
        if (dear) simplify(now);
        return;
    }
    late_ = status.physics_hz > 0 && status.real_time_now < 1 / kRoom;
    const bool few =
        status.pictures_now_hz > 0 && status.pictures_now_hz < 1.1 * curriculum::kLeastPicturesHz;
    if ((late_ && quality_.software()) || few || dear) simplify(now);
    const bool cheap = quality_.software() && !late_ && !few && cost_.count() > 0 &&
                       cost_.count() < kCheap * kAffordableMs;
    if (!cheap) cheap_since_ = now;
    if (!settled_ && now - cheap_since_ >= kSteady) enrich(now);
    const bool lost = will_not_count(status);
    if (lost && !told_slow_)
        note_ =
            "This computer is too slow: the attempt will not count. "
            "Close other programs, or make the window smaller";
    told_slow_ = lost;
}

bool PicturePace::will_not_count(const curriculum::AttemptStatus& status) {
    return status.counts_not && status.time_s > kSpeedKnownS;
}

void PicturePace::simplify(Clock::time_point now) {
    if (now - enriched_at_ < kTrial) settled_ = true;
    pictures_ = 0;
    cost_ = {};
    simplest_ = !quality_.simplify();
    if (!simplest_ && !std::exchange(told_simple_, true))
        note_ = "This computer is slow: the picture was made simpler";
}

void PicturePace::enrich(Clock::time_point now) {
    cheap_since_ = now;
    if (!quality_.enrich()) return;
    enriched_at_ = now;
    simplest_ = false;
    pictures_ = 0;
    cost_ = {};
}

std::string PicturePace::take_note() { return std::exchange(note_, {}); }

}  // namespace placode::ui

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// While simulated time stands still: before the first motion of a hand, in menu and help.

#include <algorithm>
#include <cmath>
#include <thread>

#include "curriculum/attempt_loop.h"

namespace placode::curriculum {

namespace {

// A hand that has moved this much means it: the clock starts.
constexpr float kBeginM = 0.0005F, kBeginRad = 0.05F;

}  // namespace

/// True while simulated time stands still: in help, menu and question, and until a hand has moved.
bool AttemptLoop::rest() noexcept {
    const bool paused = paused_.load(std::memory_order_relaxed);
    watch_pause(paused);
    if (!paused && !waiting_) return false;
    if (!paused && hands_moved()) {
        waiting_ = false;
        next_ = Clock::now();
        costs_.start(next_);
        speed_.start(next_, pictures_.load(std::memory_order_relaxed));
        return false;
    }
    // The tuning panel stands open meanwhile: its wishes must not pile up in a short ring.
    take_tunings();
    watch_sleep();
    publish();
    std::this_thread::sleep_for(waiting_ && !paused ? kPublishEvery / 4 : kPublishEvery);
    next_ = Clock::now();
    speed_.start(next_, pictures_.load(std::memory_order_relaxed));
    // A hand that never moves does not keep anybody from leaving.
    if (!paused && servo_->finish_requested()) reason_ = sim::EndReason::kFinished;
    if (requested_.load() != 0) reason_ = static_cast<sim::EndReason>(requested_.load());
    return true;
}

/// How long a pause lasted, and why, stands in the recording.
void AttemptLoop::watch_pause(bool paused) noexcept {
    if (paused == resting_) return;
    watch_sleep();  // What was slept until now belongs to what was until now.
    resting_ = paused;
    if (paused) {
        rest_since_ = Clock::now();
        rest_slept_s_ = sleep_.total_s();
        rest_cause_ = pause_cause_.load(std::memory_order_relaxed);
        return;
    }
    if (waiting_) return;  // nothing had begun
    const std::chrono::duration<double> awake = Clock::now() - rest_since_;
    record_pause(awake.count() + sleep_.total_s() - rest_slept_s_, rest_cause_);
}

/// A computer that sleeps stops clock and hands alike. In a pause that only makes it longer;
/// otherwise it is one of its own, and whoever shows the picture is told (`sleeps`).
void AttemptLoop::watch_sleep() noexcept {
    if (fast_) return;
    const double slept_s = sleep_.look(asleep_ns_());
    if (slept_s == 0 || resting_ || waiting_) return;
    ++sleeps_;
    record_pause(slept_s, sim::PauseCause::kAsleep);
}

void AttemptLoop::record_pause(double seconds, sim::PauseCause cause) noexcept {
    sim::Event event;
    event.kind = sim::EventKind::kPaused;
    event.time_s = state_.time_s;
    event.value = static_cast<float>(seconds);
    event.value2 = static_cast<float>(cause);
    record(event);
}

/// Nothing has been simulated yet: the instruments stand where the hands are, or nobody would see
/// with what to begin.
void AttemptLoop::show_hands(sim::Snapshot& out) const noexcept {
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        if (scene_->tools[i].kind == sim::ToolKind::kScope) continue;
        out.tools[i].pose = inputs_[i].pose();
        out.tools[i].engaged = inputs_[i].engaged;
        out.tools[i].jaw_rad = inputs_[i].jaw_rad;
    }
}

/// Against where the hands stood when they first spoke.
bool AttemptLoop::hands_moved() noexcept {
    if (!servo_->exchange().inputs.refresh()) return false;
    inputs_ = servo_->exchange().inputs.front();
    if (!has_first_) {
        first_inputs_ = inputs_;
        has_first_ = true;
        return false;
    }
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        const sim::ToolInput &now = inputs_[i], &first = first_inputs_[i];
        if (now.engaged != first.engaged || now.pedals != 0 ||
            std::abs(now.jaw_rad - first.jaw_rad) > kBeginRad)
            return true;
        float way2 = 0, turn = 0;
        for (size_t k = 0; k < 3; ++k)
            way2 += (now.position_m[k] - first.position_m[k]) *
                    (now.position_m[k] - first.position_m[k]);
        for (size_t k = 0; k < 4; ++k) turn += now.orientation[k] * first.orientation[k];
        if (way2 > kBeginM * kBeginM || 2 * std::acos(std::min(1.0F, std::abs(turn))) > kBeginRad)
            return true;
    }
    return false;
}

}  // namespace placode::curriculum

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "curriculum/stage_start.h"
#include "haptics/real_time.h"
#include "sim/world/saved_state.h"

namespace placode::curriculum {

namespace {

/// The state that the attempt begins with.
sim::State& settled(const sim::Scene& scene, sim::State& state, double seconds) noexcept {
    sim::settle(scene, state, seconds);
    return state;
}

constexpr int64_t kPublishFrames = 16;  // when running faster than real time
// Later than this the schedule starts afresh: simulated time then runs slower than the clock.
constexpr auto kLatest = std::chrono::milliseconds(5);
constexpr int64_t kFramesAhead = 400;  // of what is committed, in a fast run
constexpr int kQuietHands = 50;        // frames without a word from the servo

}  // namespace

AttemptLoop::AttemptLoop(const Task& task, const AttemptOptions& options,
                         std::shared_ptr<sim::Scene> scene, std::unique_ptr<haptics::Servo> servo,
                         AttemptRecorder& recorder)
    : scene_(scene),
      tunable_(std::move(scene)),
      servo_(std::move(servo)),
      recorder_(recorder),
      frame_s_(task.scene.solver.frame_s),
      fast_(options.fast),
      lock_step_(servo_->devices().lock_step()),
      asleep_ns_(options.asleep_ns),
      frames_per_look_(std::max<int64_t>(1, std::llround(0.016 / frame_s_))),
      state_(*scene_, std::max(1, options.threads)),
      sight_(*scene_),
      frames_(task, options.steps, *scene_, settled(*scene_, state_, task.settle_s),
              limit_of(task, options.duration_s)),
      sleep_(asleep_ns_()) {
    if (options.start) {
        sim::load_state(*scene_, state_, options.start->state);
        frames_.begin_at(stage_of(task, options.start->stage).before_step, state_);
    }
    waiting_ = options.wait_for_motion && !fast_ && !lock_step_;
    // All three slots get their memory here, not in the loop; the first picture is the settled one.
    for (int i = 0; i < 3; ++i) {
        sim::fill_snapshot(*scene_, state_, snapshots_.back());
        snapshots_.publish();
    }
}

void AttemptLoop::request_finish(sim::EndReason reason) noexcept {
    uint8_t none = 0;
    requested_.compare_exchange_strong(none, static_cast<uint8_t>(reason));
    // No force goes on without an attempt, however long its last frame takes.
    if (!lock_step_) servo_->release();
}

void AttemptLoop::set_paused(bool paused, sim::PauseCause cause) noexcept {
    if (paused) pause_cause_ = cause;
    paused_ = paused;
    servo_->set_paused(paused);
}

template <class T>
void AttemptLoop::record(const T& value) noexcept {
    while (!recorder_.put(value)) {
        // Real time waits for nobody; a fast run has all the time in the world.
        if (!fast_) {
            ++dropped_;
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

template void AttemptLoop::record<sim::Event>(const sim::Event&) noexcept;  // attempt_rest.cpp

void AttemptLoop::write(const sim::Input& input) noexcept { record(input); }
void AttemptLoop::write(const sim::Sample& sample) noexcept { record(sample); }
void AttemptLoop::write(const sim::Event& event) noexcept { record(event); }

/// Tissue that sleeps is simulated in no time: a fast run, too, keeps all but its last half second.
void AttemptLoop::wait_for_recorder() noexcept {
    while (fast_ && state_.frame - recorder_.kept() > kFramesAhead) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Shown as often as the screen is refreshed.
void AttemptLoop::perceive() noexcept {
    if (state_.frame % frames_per_look_ == 0) sight_.look(state_);
    haptics::Perception seen = sight_.seen(state_);
    seen.tools = {feedback_.data(), scene_->tools.size()};
    seen.cut_fraction = static_cast<float>(frames_.cut_fraction());
    seen.practice = frames_.goal();
    servo_->devices().perceive(seen);
}

void AttemptLoop::gather_inputs() noexcept {
    if (lock_step_) {
        perceive();
        const auto t_ns = std::llround(static_cast<double>(state_.frame) * frame_s_ * 1e9);
        servo_->tick(t_ns, {inputs_.data(), scene_->tools.size()},
                     {feedback_.data(), scene_->tools.size()});
    } else {
        // Hands that have not spoken for 50 frames hold nothing and press no pedal.
        quiet_frames_ = servo_->exchange().inputs.refresh() ? 0 : quiet_frames_ + 1;
        inputs_ = servo_->exchange().inputs.front();
        if (quiet_frames_ > kQuietHands) {
            for (sim::ToolInput& input : inputs_) input.pedals = input.engaged = 0;
        }
    }
}

/// What the clinician's panel asks for, between two frames; the ledger keeps the frame, so that a
/// replay does the same at the same place.
void AttemptLoop::take_tunings() noexcept {
    sim::Event wish;
    while (tunings_.pop(wish)) {
        wish.time_s = state_.time_s;
        wish.hash = static_cast<uint64_t>(state_.frame);
        if (sim::tune_live(*tunable_, state_, wish)) record(wish);
    }
}

void AttemptLoop::one_frame() noexcept {
    const size_t tools = scene_->tools.size();
    take_tunings();
    gather_inputs();
    const std::span<const sim::ToolInput> inputs{inputs_.data(), tools};
    wait_for_recorder();
    const sim::StepReport report =
        frames_.simulate(state_, inputs, {feedback_.data(), tools}, *this);
    if (!lock_step_) servo_->exchange().feedback.publish(feedback_);
    frames_.look(state_, report, inputs, *this);
    watch_end();
}

void AttemptLoop::watch_end() noexcept {
    const sim::EndReason own =
        frames_.ended(state_, {inputs_.data(), scene_->tools.size()}, servo_->finish_requested());
    const auto requested = static_cast<sim::EndReason>(requested_.load(std::memory_order_relaxed));
    reason_ = requested != sim::EndReason::kRunning ? requested : own;
}

void AttemptLoop::publish() noexcept {
    numbers_now_.time_s = state_.time_s;
    numbers_now_.phase = state_.phase;
    numbers_now_.physics_hz = costs_.frames_per_s();
    numbers_now_.frame_p99_ms = costs_.p99_ms();
    numbers_now_.substeps = state_.substeps;
    numbers_now_.cut_fraction = frames_.cut_fraction();
    numbers_now_.dropped = dropped_;
    numbers_now_.sleeps = sleeps_;
    numbers_now_.waiting = waiting_;
    numbers_now_.real_time = speed_.real_time();
    numbers_now_.pictures_hz = speed_.pictures_hz();
    numbers_now_.real_time_now = speed_.real_time_now();
    numbers_now_.pictures_now_hz = speed_.pictures_now_hz();
    numbers_now_.slow = speed_.slow();
    numbers_now_.counts_not = speed_.counts_for_nothing();
    numbers_.publish(numbers_now_);
    sim::Snapshot& out = snapshots_.back();
    sim::fill_snapshot(*scene_, state_, out);
    out.physics_hz = static_cast<float>(numbers_now_.physics_hz);
    out.servo_p999_us = servo_p999_us_.load(std::memory_order_relaxed);
    out.substeps = state_.substeps;
    out.finished = reason_ != sim::EndReason::kRunning ? 1 : 0;
    out.paused = paused_.load(std::memory_order_relaxed) ? 1 : 0;
    out.message = frames_.warnings().phrase();
    out.message_age_s =
        static_cast<float>(std::min(1e9, state_.time_s - frames_.warnings().said_s()));
    if (waiting_ && has_first_) show_hands(out);
    snapshots_.publish();
    practice_out_.publish(frames_.goal());
}

void AttemptLoop::keep_pace() noexcept {
    const auto now = Clock::now();
    if (fast_) {
        if (state_.frame % kPublishFrames == 0) publish();
        return;
    }
    if (now - published_ >= kPublishEvery) {
        watch_sleep();
        publish();
        published_ = now;
    }
    next_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(frame_s_));
    if (now > next_ + kLatest)
        next_ = now;
    else if (next_ > now)
        std::this_thread::sleep_until(next_);
}

// A thread of the FIFO class that never sleeps would starve picture, recorder and desktop: beyond
// four fifths of its period it goes back to the ordinary scheduler for good.
void AttemptLoop::leave_room() noexcept {
    if (!real_time_ || costs_.smoothed_s() < 0.8 * frame_s_) return;
    haptics::make_thread_ordinary();
    real_time_ = false;
}

void AttemptLoop::run() noexcept {
    servo_->start();
    // Hands that feel come before pictures; the others need no more than the usual share.
    real_time_ = !lock_step_ && servo_->renders_force() &&
                 haptics::make_thread_real_time(haptics::kPhysicsPriority);
    next_ = published_ = Clock::now();
    costs_.start(next_);
    frames_.begin(*this);
    speed_.start(next_, pictures_.load(std::memory_order_relaxed));
    while (reason_ == sim::EndReason::kRunning) {
        if (rest()) continue;
        const auto start = Clock::now();
        one_frame();
        const auto now = Clock::now();
        costs_.add(now - start, now);
        leave_room();
        if (!fast_ && !lock_step_) {
            const int wanted = scene_->body.spec().solver.substeps;
            const int substeps = costs_.adapted(state_.substeps, wanted, frame_s_);
            if (substeps > state_.substeps || may_save_.load(std::memory_order_relaxed))
                state_.substeps = substeps;
        }
        keep_pace();
        if (fast_ || lock_step_) continue;
        const auto spell = speed_.frame(Clock::now(), frame_s_,
                                        pictures_.load(std::memory_order_relaxed), state_.time_s);
        if (spell) record(*spell);
    }
    servo_->stop();
    close();
}

/// The last events, and what the recording ends with.
void AttemptLoop::close() noexcept {
    frames_.close(state_, *this);
    watch_sleep();
    watch_pause(false);
    if (const auto speed = speed_.closing(state_.time_s)) record(*speed);
    end_ = frames_.seal(state_, reason_, *this);
    end_.dropped = dropped_;
    publish();
    finished_.store(true, std::memory_order_release);
}

}  // namespace placode::curriculum

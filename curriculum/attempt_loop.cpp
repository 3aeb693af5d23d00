// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "curriculum/attempt_sample.h"
#include "curriculum/preset.h"
#include "haptics/real_time.h"
#include "sim/cutting/attempt_progress.h"
#include "sim/ledger/damage.h"

namespace placode::curriculum {

namespace {

using sim::EventKind;

constexpr double kCutFraction = 0.995, kLiftedM = 0.001, kLiftedS = 1.0;
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
      time_limit_s_(limit_of(task, options.duration_s)),
      frame_s_(task.scene.solver.frame_s),
      finish_when_cut_(task.finish_when_cut),
      fast_(options.fast),
      lock_step_(servo_->devices().lock_step()),
      preset_(!preset_of(task).empty()),
      frames_per_sample_(std::max<int64_t>(1, std::llround(0.01 / frame_s_))),
      frames_per_look_(std::max<int64_t>(1, std::llround(0.016 / frame_s_))),
      state_(*scene_, std::max(1, options.threads)),
      sight_(*scene_),
      warnings_(*scene_),
      used_substeps_(state_.substeps) {
    sim::settle(*scene_, state_, task.settle_s);
    waiting_ = options.wait_for_motion && !fast_ && !lock_step_;
    practice_ = PracticeGuide(options.steps, *scene_, state_);
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

/// Tissue that sleeps is simulated in no time: a fast run, too, keeps all but its last half second.
void AttemptLoop::wait_for_recorder() noexcept {
    while (fast_ && state_.frame - recorder_.kept() > kFramesAhead) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

void AttemptLoop::record_event(EventKind kind, float value, uint64_t hash) noexcept {
    sim::Event event;
    event.time_s = state_.time_s;
    event.kind = kind;
    event.value = value;
    event.hash = hash;
    record(event);
}

/// Shown as often as the screen is refreshed.
void AttemptLoop::perceive() noexcept {
    if (state_.frame % frames_per_look_ == 0) sight_.look(state_);
    haptics::Perception seen = sight_.seen(state_);
    seen.tools = {feedback_.data(), scene_->tools.size()};
    seen.cut_fraction = static_cast<float>(numbers_now_.cut_fraction);
    seen.practice = practice_.goal();
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
    sim::Input input;
    input.frame = state_.frame;
    input.substeps = used_substeps_ = state_.substeps;
    input.tool_count = static_cast<int32_t>(tools);
    for (size_t i = 0; i < tools; ++i) input.tools[i] = inputs_[i];
    record(input);
    wait_for_recorder();
    const sim::StepReport report =
        sim::step(*scene_, state_, {inputs_.data(), tools}, {feedback_.data(), tools});
    if (!lock_step_) servo_->exchange().feedback.publish(feedback_);
    hand_out(report);
}

void AttemptLoop::hand_out(const sim::StepReport& report) noexcept {
    sample_flags_ |= report.flags;
    for (int i = 0; i < state_.event_count; ++i) record(state_.events[static_cast<size_t>(i)]);
    numbers_now_.cut_fraction = sim::ring_share(state_);
    const bool sampled = state_.frame % frames_per_sample_ == 0;
    warnings_.look(state_, {inputs_.data(), scene_->tools.size()}, sampled);
    for (const sim::Event& event : warnings_.events()) record(event);
    if (sampled) take_sample();
    watch_end();
}

void AttemptLoop::take_sample() noexcept {
    sim::Sample sample = sample_of(*scene_, state_, {inputs_.data(), scene_->tools.size()});
    sample.cut_fraction = static_cast<float>(numbers_now_.cut_fraction);
    sample.step_flags = sample_flags_;
    sample_flags_ = 0;
    record(sample);
    practise(sample);
}

/// What was done of a practice task is written into the ledger.
void AttemptLoop::practise(const sim::Sample& sample) noexcept {
    for (const sim::Event& event :
         practice_.see(state_, {inputs_.data(), scene_->tools.size()}, sample)) {
        record(event);
        if (event.kind == sim::EventKind::kTargetMissed)
            warnings_.say("Beside the mark", state_.time_s);
    }
}

void AttemptLoop::watch_end() noexcept {
    bool lifted = true;
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        if (scene_->tools[i].kind == sim::ToolKind::kScope) continue;
        lifted = lifted && inputs_[i].pedals == 0 && state_.tools[i].tip_gap_m > kLiftedM;
    }
    const bool cut = finish_when_cut_ && numbers_now_.cut_fraction >= kCutFraction;
    lifted_s_ = cut && lifted ? lifted_s_ + frame_s_ : 0;
    // A moment to see the last step ticked off.
    practised_s_ = practice_.done() ? practised_s_ + frame_s_ : 0;
    const auto requested = static_cast<sim::EndReason>(requested_.load(std::memory_order_relaxed));
    if (requested != sim::EndReason::kRunning)
        reason_ = requested;
    else if (servo_->finish_requested() || lifted_s_ >= kLiftedS || practised_s_ >= kLiftedS)
        reason_ = sim::EndReason::kFinished;
    else if (state_.time_s >= time_limit_s_ - frame_s_ / 2)
        reason_ = sim::EndReason::kTimeLimit;
}

void AttemptLoop::publish() noexcept {
    numbers_now_.time_s = state_.time_s;
    numbers_now_.phase = state_.phase;
    numbers_now_.physics_hz = costs_.frames_per_s();
    numbers_now_.frame_p99_ms = costs_.p99_ms();
    numbers_now_.substeps = state_.substeps;
    numbers_now_.dropped = dropped_;
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
    out.message = warnings_.phrase();
    out.message_age_s = static_cast<float>(std::min(1e9, state_.time_s - warnings_.said_s()));
    if (waiting_ && has_first_) show_hands(out);
    snapshots_.publish();
    practice_out_.publish(practice_.goal());
}

void AttemptLoop::keep_pace() noexcept {
    const auto now = Clock::now();
    if (fast_) {
        if (state_.frame % kPublishFrames == 0) publish();
        return;
    }
    if (now - published_ >= kPublishEvery) {
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
    if (preset_) {
        sim::Event event;
        event.kind = sim::EventKind::kTuned;
        event.element = static_cast<int32_t>(sim::TuneParameter::kPreset);
        record(event);
    }
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
    for (const sim::Event& event : practice_.end(state_.time_s)) record(event);
    for (const sim::Event& event : warnings_.end(state_.time_s)) record(event);
    try {
        for (const sim::Event& event : sim::reached_events(*scene_, state_)) record(event);
        for (const sim::Event& event : sim::closing_events(*scene_, state_)) record(event);
    } catch (const std::exception&) {
        // Without memory for it gaps or thermal spread are not known; the attempt is.
    }
    watch_pause(false);
    if (const auto speed = speed_.closing(state_.time_s)) record(*speed);
    if (reason_ == sim::EndReason::kFinished) record_event(EventKind::kFinished, 0, 0);
    // `adapt` may have chosen substeps for a frame that never came; the hash covers their number.
    state_.substeps = used_substeps_;
    end_.final_hash = sim::state_hash(state_);
    end_.reason = reason_;
    end_.duration_s = state_.time_s;
    end_.dropped = dropped_;
    record_event(EventKind::kStateHash, 0, end_.final_hash);
    publish();
    finished_.store(true, std::memory_order_release);
}

}  // namespace placode::curriculum

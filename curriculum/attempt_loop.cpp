// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <numbers>
#include <thread>

#include "curriculum/preset.h"
#include "haptics/real_time.h"
#include "sim/damage.h"

namespace placode::curriculum {

namespace {

using sim::EventKind;
using sim::Vec3;

constexpr double kCutFraction = 0.995, kLiftedM = 0.001, kLiftedS = 1.0;
constexpr double kNearPlacodeM = 0.001;
constexpr auto kPublishEvery = std::chrono::milliseconds(16);
constexpr int64_t kPublishFrames = 16;  // when running faster than real time
// Later than this the schedule starts afresh: simulated time then runs slower than the clock.
constexpr auto kLatest = std::chrono::milliseconds(5);
constexpr int kFewestSubsteps = 2;
constexpr int kSlowFrames = 200, kQuickFrames = 2000;  // before the substeps change
constexpr size_t kCosts = 1024;
constexpr int64_t kFramesAhead = 400;  // of what is committed, in a fast run
constexpr int kQuietHands = 50;        // frames without a word from the servo

bool is_electric(sim::ToolKind kind) {
    return kind == sim::ToolKind::kNeedle || kind == sim::ToolKind::kHook;
}

}  // namespace

bool tip_in_view(const sim::Scene& scene, const sim::State& state, size_t tool) noexcept {
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        const sim::ToolSpec& scope = scene.tools[i];
        if (scope.kind != sim::ToolKind::kScope) continue;
        if (i == tool) return true;
        const sim::Pose& pose = state.tools[i].proxy;
        // An oblique scope looks down in its own picture (+y of the camera is down).
        const double tilt = scope.scope_angle_deg * std::numbers::pi / 180;
        const Vec3 axis = pose.q * Vec3(0, std::sin(tilt), std::cos(tilt));
        const Vec3 away = state.tools[tool].proxy.p - pose.p;
        const double half = scope.field_of_view_deg / 2 * std::numbers::pi / 180;
        return away.dot(axis) >= away.norm() * std::cos(half);
    }
    return true;
}

AttemptLoop::AttemptLoop(const Task& task, const AttemptOptions& options,
                         std::shared_ptr<sim::Scene> scene, std::unique_ptr<haptics::Servo> servo,
                         AttemptRecorder& recorder)
    : scene_(scene),
      tunable_(std::move(scene)),
      servo_(std::move(servo)),
      recorder_(recorder),
      time_limit_s_(options.duration_s > 0 ? std::min(options.duration_s, task.time_limit_s)
                                           : task.time_limit_s),
      frame_s_(task.scene.solver.frame_s),
      finish_when_cut_(task.finish_when_cut),
      fast_(options.fast),
      lock_step_(servo_->devices().lock_step()),
      preset_(!preset_of(task).empty()),
      frames_per_sample_(std::max<int64_t>(1, std::llround(0.01 / frame_s_))),
      frames_per_look_(std::max<int64_t>(1, std::llround(0.016 / frame_s_))),
      state_(*scene_, std::max(1, options.threads)),
      sight_(*scene_),
      costs_ms_(kCosts, 0.0f),
      sorted_ms_(kCosts, 0.0f) {
    if (scene_->geometry.placode_edge.size() >= 3) placode_.emplace(scene_->geometry.placode_edge);
    used_substeps_ = state_.substeps;
    sim::settle(*scene_, state_, task.settle_s);
    if (!options.steps.empty()) {
        std::vector<sim::PracticeStep> goals;
        for (const TaskStep& step : options.steps) goals.push_back(step.goal);
        practice_.emplace(goals, scene_->tools, scene_->geometry);
        target_vertex_.resize(goals.size(), {-1, -1});
        for (size_t i = 0; i < goals.size(); ++i) find_targets(goals[i], target_vertex_[i]);
        goal_.count = practice_->count();
        look_at_goal();
    }
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

void AttemptLoop::set_paused(bool paused) noexcept {
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
    seen.practice = goal_;
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
        if (sim::retune(*tunable_, state_, wish)) record(wish);
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
    const size_t points = state_.progress.cut.size();
    numbers_now_.cut_fraction =
        points > 0 ? static_cast<double>(state_.progress.cut_count) / static_cast<double>(points)
                   : 0;
    warn();
    if (state_.frame % frames_per_sample_ == 0) take_sample();
    watch_end();
}

void AttemptLoop::take_sample() noexcept {
    sim::Sample sample;
    sample.time_s = state_.time_s;
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        const sim::ToolState& tool = state_.tools[i];
        sim::ToolSample& out = sample.tools[i];
        sim::ToolInput pose;  // for its conversion to float
        pose.set_pose(tool.proxy);
        out.tip_m = pose.position_m;
        out.orientation = pose.orientation;
        for (int k = 0; k < 3; ++k)
            out.force_n[static_cast<size_t>(k)] = static_cast<float>(tool.force_n[k]);
        out.jaw_rad = inputs_[i].jaw_rad;
        out.tip_gap_m = static_cast<float>(tool.tip_gap_m);
        out.power_w = static_cast<float>(tool.power_in_tissue_w);
        out.pedals = inputs_[i].pedals;
        out.in_contact = tool.in_contact;
        out.in_view = tip_in_view(*scene_, state_, i) ? 1 : 0;
        out.touched = tool.touched;
    }
    sample.placode_peak_c = state_.placode_peak_c;
    sample.placode_peak_cem43_min = state_.placode_peak_cem43_min;
    sample.placode_burned_m3 = state_.placode_burned_m3;
    sample.cut_fraction = static_cast<float>(numbers_now_.cut_fraction);
    sample.phase = state_.phase;
    sample.step_flags = sample_flags_;
    sample_flags_ = 0;
    record(sample);
    if (practice_) practise(sample);
}

/// The surface vertices that stand for a step's targets: targets move with the tissue.
void AttemptLoop::find_targets(const sim::PracticeStep& step, std::array<int32_t, 2>& out) {
    for (int t = 0; t < sim::targets_of(step.kind); ++t) {
        const sim::Vec2 wanted = assessment::practice_target(step, scene_->geometry, t == 1);
        double nearest = 1;
        for (size_t v = 0; v < scene_->field.depth_m.size(); ++v) {
            if (scene_->field.depth_m[v] > 0) continue;
            const double way = (to_vec(state_.body.x[v]).head<2>() - wanted).norm();
            if (way >= nearest) continue;
            nearest = way;
            out[static_cast<size_t>(t)] = static_cast<int32_t>(v);
        }
    }
}

void AttemptLoop::look_at_goal() noexcept {
    goal_.index = practice_->index();
    goal_.step = practice_->step();
    goal_.progress = practice_->progress();
    goal_.traced = practice_->traced();
    goal_.targets = 0;
    if (practice_->done()) return;
    for (const int32_t v : target_vertex_[static_cast<size_t>(goal_.index)]) {
        if (v < 0) continue;
        goal_.target_m[static_cast<size_t>(goal_.targets++)] =
            to_vec(state_.body.x[static_cast<size_t>(v)]);
    }
}

/// One sample for the steps of a practice task; what was done is written into the ledger.
void AttemptLoop::practise(const sim::Sample& sample) noexcept {
    look_at_goal();
    assessment::PracticeSight sight{
        sample, {goal_.target_m.data(), static_cast<size_t>(goal_.targets)}, {}, {}, {}};
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        sight.holds[i] = state_.grasps[i].count > 0;
        sight.pull_n[i] = state_.grasps[i].force_n.norm();
        sight.engaged[i] = inputs_[i].engaged != 0;
    }
    for (const sim::Event& event : practice_->see(sight)) {
        record(event);
        if (event.kind == sim::kTargetMissed) say("Beside the mark");
    }
    look_at_goal();
}

void AttemptLoop::say(const char* phrase) noexcept {
    message_.fill('\0');
    std::strncpy(message_.data(), phrase, message_.size() - 1);
    message_at_s_ = state_.time_s;
}

/// The newest warning, the worst last so that it wins.
void AttemptLoop::warn() noexcept {
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        const sim::ToolState& tool = state_.tools[i];
        if (scene_->tools[i].kind == sim::ToolKind::kScope) continue;
        const bool energised = is_electric(scene_->tools[i].kind) && inputs_[i].pedals != 0;
        if (tool.air_s > 1) say("Energy in air");
        if (tool.dwell_s > 1) say("Too long on one spot");
        if (energised && state_.frame % frames_per_sample_ == 0) {
            const sim::Vec2 tip = tool.proxy.p.head<2>();
            if (placode_ && tool.in_contact != 0 && placode_->nearest(tip).offset < kNearPlacodeM)
                say("Too close to the placode");
            if (!tip_in_view(*scene_, state_, i)) say("Energy out of view");
        }
        if (tool.in_contact != 0 && tool.touched == sim::Tissue::kPlacode && tool.contact_s > 0)
            say("Placode touched");
    }
    for (int i = 0; i < state_.event_count; ++i) {
        switch (state_.events[static_cast<size_t>(i)].kind) {
            case EventKind::kOverForce:
                say("Too much force");
                break;
            case EventKind::kTorn:
                say("Tissue torn");
                break;
            case EventKind::kSlipped:
                say("Grasp slips");
                break;
            case EventKind::kCrushed:
                say("Tissue crushed");
                break;
            case EventKind::kOverTraction:
                say("Pulled too hard");
                break;
            case EventKind::kPlacodeCut:
                say("Placode cut");
                break;
            case EventKind::kPlacodeOverheated:
                say("Placode heated");
                break;
            case EventKind::kPlacodeBurned:
                say("Placode burned");
                break;
            default:
                break;
        }
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
    practised_s_ = practice_ && practice_->done() ? practised_s_ + frame_s_ : 0;
    const auto requested = static_cast<sim::EndReason>(requested_.load(std::memory_order_relaxed));
    if (requested != sim::EndReason::kRunning)
        reason_ = requested;
    else if (servo_->finish_requested() || lifted_s_ >= kLiftedS || practised_s_ >= kLiftedS)
        reason_ = sim::EndReason::kFinished;
    else if (state_.time_s >= time_limit_s_ - frame_s_ / 2)
        reason_ = sim::EndReason::kTimeLimit;
}

/// Frame cost for the display and for the choice of substeps.
void AttemptLoop::measure(Clock::duration cost) noexcept {
    const double seconds = std::chrono::duration<double>(cost).count();
    cost_s_ += 0.02 * (seconds - cost_s_);
    costs_ms_[cost_count_++ % kCosts] = static_cast<float>(seconds * 1e3);
    ++second_frames_;
    const auto now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - second_).count();
    if (elapsed < 1) return;
    numbers_now_.physics_hz = second_frames_ / elapsed;
    second_ = now;
    second_frames_ = 0;
    const size_t n = std::min(cost_count_, kCosts);
    std::copy_n(costs_ms_.begin(), n, sorted_ms_.begin());
    const auto p99 = sorted_ms_.begin() + static_cast<long>((n - 1) * 99 / 100);
    std::nth_element(sorted_ms_.begin(), p99, sorted_ms_.begin() + static_cast<long>(n));
    numbers_now_.frame_p99_ms = *p99;
}

/// Fewer substeps when frames take longer than they stand for, more again when there is room. Only
/// for hands: a script must give the same bits at any speed of the machine.
void AttemptLoop::adapt(double frame_s) noexcept {
    const int wanted = scene_->body.spec().solver.substeps;
    slow_frames_ = cost_s_ > 0.95 * frame_s ? slow_frames_ + 1 : 0;
    // One substep more must still fit, or the number would swing to and fro.
    const double room = 0.8 * frame_s * state_.substeps / (state_.substeps + 1);
    quick_frames_ = cost_s_ < room ? quick_frames_ + 1 : 0;
    if (slow_frames_ >= kSlowFrames && state_.substeps > std::min(kFewestSubsteps, wanted)) {
        --state_.substeps;
        slow_frames_ = 0;
    } else if (quick_frames_ >= kQuickFrames && state_.substeps < wanted) {
        ++state_.substeps;
        quick_frames_ = 0;
    }
}

void AttemptLoop::publish() noexcept {
    numbers_now_.time_s = state_.time_s;
    numbers_now_.phase = state_.phase;
    numbers_now_.substeps = state_.substeps;
    numbers_now_.dropped = dropped_;
    numbers_.publish(numbers_now_);
    sim::Snapshot& out = snapshots_.back();
    sim::fill_snapshot(*scene_, state_, out);
    out.physics_hz = static_cast<float>(numbers_now_.physics_hz);
    out.servo_p999_us = servo_p999_us_.load(std::memory_order_relaxed);
    out.substeps = state_.substeps;
    out.finished = reason_ != sim::EndReason::kRunning ? 1 : 0;
    out.paused = paused_.load(std::memory_order_relaxed) ? 1 : 0;
    out.message = message_;
    out.message_age_s = static_cast<float>(std::min(1e9, state_.time_s - message_at_s_));
    snapshots_.publish();
    practice_out_.publish(goal_);
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
    if (!real_time_ || cost_s_ < 0.8 * frame_s_) return;
    haptics::make_thread_ordinary();
    real_time_ = false;
}

void AttemptLoop::run() noexcept {
    servo_->start();
    // Hands that feel come before pictures; the others need no more than the usual share.
    real_time_ = !lock_step_ && servo_->renders_force() &&
                 haptics::make_thread_real_time(haptics::kPhysicsPriority);
    next_ = published_ = second_ = Clock::now();
    if (preset_) {
        sim::Event event;
        event.kind = sim::kTuned;
        event.element = static_cast<int32_t>(sim::TuneParameter::kPreset);
        record(event);
    }
    while (reason_ == sim::EndReason::kRunning) {
        if (paused_.load(std::memory_order_relaxed)) {
            publish();
            std::this_thread::sleep_for(kPublishEvery);
            next_ = Clock::now();
            if (requested_.load() == 0) continue;
            reason_ = static_cast<sim::EndReason>(requested_.load());
            break;
        }
        const auto start = Clock::now();
        one_frame();
        measure(Clock::now() - start);
        leave_room();
        if (!fast_ && !lock_step_) adapt(frame_s_);
        keep_pace();
    }
    servo_->stop();
    if (practice_) {
        for (const sim::Event& event : practice_->end(state_.time_s)) record(event);
    }
    try {
        for (const sim::Event& event : sim::closing_events(*scene_, state_)) record(event);
    } catch (const std::exception&) {
        // Without memory for it thermal spread is not known; the attempt is.
    }
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

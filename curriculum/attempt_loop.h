// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The physics thread of an attempt: hands in, one frame, everything out. Within a frame it neither
// locks, allocates nor throws. Private to curriculum.

#include <atomic>
#include <chrono>
#include <memory>

#include "curriculum/attempt_frames.h"
#include "curriculum/attempt_recorder.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/frame_costs.h"
#include "curriculum/machine_speed.h"
#include "curriculum/operator_sight.h"
#include "curriculum/sleep_watch.h"
#include "sim/step/live_tuning.h"

namespace placode::curriculum {

/// Numbers for the main thread, published with every snapshot.
struct LoopNumbers {
    double time_s = 0;
    sim::Phase phase = sim::Phase::kInspect;
    double physics_hz = 0, frame_p99_ms = 0;
    int substeps = 0;
    double cut_fraction = 0;
    int64_t dropped = 0;
    int sleeps = 0;                                 ///< As in AttemptStatus.
    bool waiting = false;                           ///< For the first motion of a hand.
    double real_time = 1;                           ///< Simulated over wall-clock time.
    double real_time_now = 1, pictures_now_hz = 0;  ///< Of the last second.
    double pictures_hz = 0;                         ///< In nine of ten seconds.
    bool slow = false;                              ///< Has not kept up for some seconds.
    bool counts_not = false;                        ///< As it is now, too slow to count.
};

class AttemptLoop final : private AttemptBook {
 public:
    AttemptLoop(const Task& task, const AttemptOptions& options, std::shared_ptr<sim::Scene> scene,
                std::unique_ptr<haptics::Servo> servo, AttemptRecorder& recorder);

    void run() noexcept;  ///< The thread's body, from the first frame to the end.

    // Main thread.
    void request_finish(sim::EndReason reason) noexcept;
    void set_paused(bool paused, sim::PauseCause cause) noexcept;
    void picture_drawn() noexcept { pictures_.fetch_add(1, std::memory_order_relaxed); }
    /// Whether fewer substeps may be taken when time is short: first the picture is made simpler.
    void may_save_substeps(bool may) noexcept { may_save_ = may; }
    /// Changes tissue or generator before the next frame (sim/step/live_tuning.h); false when too
    /// many wait.
    bool tune(const sim::Event& wish) noexcept { return tunings_.push(wish); }
    [[nodiscard]] bool finished() const noexcept { return finished_; }
    [[nodiscard]] sim::Latest<sim::Snapshot>& snapshots() noexcept { return snapshots_; }
    [[nodiscard]] sim::Latest<LoopNumbers>& numbers() noexcept { return numbers_; }
    [[nodiscard]] sim::Latest<sim::PracticeGoal>& practice() noexcept { return practice_out_; }
    [[nodiscard]] const haptics::Servo& servo() const noexcept { return *servo_; }
    void set_servo_p999(double us) noexcept { servo_p999_us_ = static_cast<float>(us); }
    [[nodiscard]] const sim::RecordingEnd& end() const noexcept { return end_; }  ///< After run().

 private:
    using Clock = FrameCosts::Clock;

    static constexpr auto kPublishEvery = std::chrono::milliseconds(16);  // as often as a screen

    [[nodiscard]] bool rest() noexcept;
    void watch_pause(bool paused) noexcept;
    void watch_sleep() noexcept;
    void record_pause(double seconds, sim::PauseCause cause) noexcept;
    [[nodiscard]] bool hands_moved() noexcept;
    void show_hands(sim::Snapshot& out) const noexcept;
    void gather_inputs() noexcept;
    void perceive() noexcept;
    void one_frame() noexcept;
    void watch_end() noexcept;
    void close() noexcept;
    void take_tunings() noexcept;
    void publish() noexcept;
    void keep_pace() noexcept;
    template <class T>
    void record(const T& value) noexcept;
    void write(const sim::Input& input) noexcept override;
    void write(const sim::Sample& sample) noexcept override;
    void write(const sim::Event& event) noexcept override;
    void wait_for_recorder() noexcept;
    void leave_room() noexcept;

    // constant
    std::shared_ptr<const sim::Scene> scene_;
    std::shared_ptr<sim::Scene> tunable_;  // the same, for the clinician's panel alone
    std::unique_ptr<haptics::Servo> servo_;
    AttemptRecorder& recorder_;
    double frame_s_;
    bool fast_, lock_step_;
    int64_t (*asleep_ns_)() noexcept;
    int64_t frames_per_look_;
    // crosses threads
    std::atomic<uint8_t> requested_{0};
    std::atomic<bool> paused_{false}, finished_{false};
    std::atomic<sim::PauseCause> pause_cause_{sim::PauseCause::kMenu};
    std::atomic<bool> may_save_{true};
    std::atomic<uint64_t> pictures_{0};
    std::atomic<float> servo_p999_us_{0};
    sim::Latest<sim::Snapshot> snapshots_;
    sim::Latest<LoopNumbers> numbers_;
    sim::Latest<sim::PracticeGoal> practice_out_;
    sim::Ring<sim::Event> tunings_{64};
    // physics thread
    sim::State state_;
    std::array<sim::ToolInput, sim::kMaxTools> inputs_{};
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback_{};
    OperatorSight sight_;
    AttemptFrames frames_;
    FrameCosts costs_;
    MachineSpeed speed_;
    bool waiting_ = false, has_first_ = false, resting_ = false;
    std::array<sim::ToolInput, sim::kMaxTools> first_inputs_{};
    Clock::time_point rest_since_{};
    double rest_slept_s_ = 0;  // before the pause
    SleepWatch sleep_;
    int sleeps_ = 0;
    sim::PauseCause rest_cause_ = sim::PauseCause::kMenu;
    int64_t dropped_ = 0;
    sim::EndReason reason_ = sim::EndReason::kRunning;
    sim::RecordingEnd end_;
    Clock::time_point next_{}, published_{};
    int quiet_frames_ = 0;
    bool real_time_ = false;  // SCHED_FIFO was granted and is kept
    LoopNumbers numbers_now_;
};

}  // namespace placode::curriculum

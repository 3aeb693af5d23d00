// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between Start and the score: device, simulation and recording of one attempt, without a window.

#include <functional>
#include <memory>
#include <string>

#include "curriculum/conduct.h"
#include "curriculum/task.h"
#include "haptics/real_time.h"
#include "haptics/servo.h"
#include "sim/step/live_tuning.h"
#include "sim/step/recording.h"
#include "sim/step/snapshot.h"

namespace placode::curriculum {

struct StageStart;  // stage_start.h

struct AttemptOptions {
    std::string device = "mouse";  ///< As on the command line; "play:FILE" is handled by replay().
    int threads = 2;
    bool fast = false;      ///< As fast as possible instead of real time.
    double duration_s = 0;  ///< Stop after; 0 = the task's limit.
    bool demonstration = false;
    std::string started_utc;
    sim::Latest<sim::WindowInput>* window = nullptr;
    AttemptMode mode = AttemptMode::kPractice;
    /// Simulated time starts with the first motion of a hand. Scripts and fast runs do not wait.
    bool wait_for_motion = false;
    /// As haptics::asleep_ns(); a test brings its own. Any thread.
    int64_t (*asleep_ns)() noexcept = haptics::asleep_ns;
    std::vector<TaskStep> steps;  ///< Filled by the runner: what the device can do of the task's.
    /// What the attempt begins with, of the same task and seed; null = with the beginning. Only in
    /// practice.
    std::shared_ptr<const StageStart> start;
};

struct AttemptStatus {
    double time_s = 0;
    sim::Phase phase = sim::Phase::kInspect;
    double physics_hz = 0;  ///< Frames per second of wall clock, last second.
    double frame_p99_ms = 0;
    int substeps = 0;
    double cut_fraction = 0;
    double servo_p999_us = 0;
    uint64_t servo_missed = 0, servo_gaps = 0, servo_faults = 0;  ///< As in the certificate.
    int64_t dropped = 0;
    bool running = true;
    bool waiting = false;      ///< For the first motion of a hand.
    int sleeps = 0;            ///< Times that the computer slept while simulated time ran.
    bool device_lost = false;  ///< No hand has a device any more.
    int in_hand = -1;          ///< The tool that one hand at a window moves; -1 = each has its own.
    double real_time = 1;      ///< Simulated over wall-clock time (curriculum/machine_speed.h).
    double real_time_now = 1, pictures_now_hz = 0;  ///< Of the last second.
    double pictures_hz = 0;                         ///< In nine of ten seconds.
    bool slow = false;                              ///< Has not kept up for some seconds.
    bool counts_not = false;                        ///< As it is now, too slow to count.
    std::string warning;                            ///< e.g. why the recording stopped.
};

/// Version and instruction set: what this program writes into RecordingHeader::build. Bits are
/// promised for the same only.
[[nodiscard]] std::string this_build();

/// Runs one attempt on its own physics and recorder threads (or on the caller's in `run_fast`).
class AttemptRunner {
 public:
    /// Throws DeviceError or MeshError, and for a start that does not fit StateError,
    /// DefinitionError. `sink` may be null (nothing is recorded).
    AttemptRunner(Task task, uint64_t seed, AttemptOptions options,
                  std::unique_ptr<sim::RecordingSink> sink);
    ~AttemptRunner();

    void start();                                         ///< Starts the threads.
    void request_finish(sim::EndReason reason) noexcept;  ///< Main thread: menu, window closed.
    void set_paused(bool paused, sim::PauseCause cause = sim::PauseCause::kMenu) noexcept;
    void picture_drawn() noexcept;  ///< The view tells each of them.
    /// Fewer substeps when time is short only once the picture cannot be made simpler.
    void may_save_substeps(bool may) noexcept;
    /// Changes tissue or generator before the next frame. Main thread. The attempt then counts as
    /// tuned: it is recorded, replayed exactly, and never passes.
    void tune(sim::TuneParameter parameter, sim::Tissue tissue, double value) noexcept;
    [[nodiscard]] bool finished() const noexcept;
    void wait();  ///< Until finished and everything is written.

    [[nodiscard]] const std::shared_ptr<const sim::Scene>& scene() const noexcept;
    [[nodiscard]] const Task& task() const noexcept;
    /// Newest snapshot (main thread); true in `fresh` when it changed.
    [[nodiscard]] const sim::Snapshot& snapshot(bool* fresh = nullptr) noexcept;
    /// Where the steps of a practice task stand (main thread); count == 0 = it has none.
    [[nodiscard]] const sim::PracticeGoal& practice() noexcept;
    [[nodiscard]] AttemptStatus status() const;
    [[nodiscard]] sim::RecordingEnd end() const;  ///< After wait().
    /// What the haptic loop has done so far, as JSON (haptics/certificate.h).
    [[nodiscard]] std::string haptic_certificate() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Outcome of a replay.
struct ReplayResult {
    bool identical = false;
    int64_t frames = 0;
    double first_difference_s = -1;  ///< Time of the first state hash that differs.
    std::string message;             ///< "replay: identical" or where and what differs.
};

/// Re-simulates a recording and compares every state hash in it. `on_frame` may be empty.
[[nodiscard]] ReplayResult replay(
    const sim::Recording& recording, int threads,
    const std::function<void(const sim::Scene&, const sim::State&)>& on_frame = {});

}  // namespace placode::curriculum

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recorder thread: takes what the physics thread put into the rings and gives it to the sink
// several times a second. A sink that fails ends the recording, never the attempt.

#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "sim/core/exchange.h"
#include "sim/step/recording.h"

namespace placode::curriculum {

struct StageStart;  // stage_start.h

class AttemptRecorder {
 public:
    /// `sink` may be null: everything put in is thrown away.
    /// `start`: what was given, which is recorded first; null = nothing.
    AttemptRecorder(std::unique_ptr<sim::RecordingSink> sink, sim::RecordingHeader header,
                    std::shared_ptr<const StageStart> start = {});
    ~AttemptRecorder();

    /// Starts the thread, which calls sink->begin first.
    void start();
    /// Writes the rest and the end, ends the thread. Owner thread, after the physics thread ended.
    void finish(const sim::RecordingEnd& end);
    /// Why nothing is recorded any more; empty = all is well. Any thread but physics.
    [[nodiscard]] std::string problem() const;

    // Physics thread. False: the ring is full.
    [[nodiscard]] bool put(const sim::Input& input) noexcept;
    [[nodiscard]] bool put(const sim::Sample& sample) noexcept;
    [[nodiscard]] bool put(const sim::Event& event) noexcept;
    /// Frames that the sink has committed; without a sink as many as one likes. Any thread.
    [[nodiscard]] int64_t kept() const noexcept {
        return discard_.load(std::memory_order_relaxed) ? std::numeric_limits<int64_t>::max()
                                                        : kept_.load(std::memory_order_relaxed);
    }

 private:
    void run();
    void drain(bool everything);
    void give_up(const std::string& why);

    std::unique_ptr<sim::RecordingSink> sink_;
    sim::RecordingHeader header_;
    std::shared_ptr<const StageStart> start_;
    sim::RecordingEnd end_;
    std::thread thread_;
    std::atomic<bool> discard_;  // recorder writes, physics reads
    std::atomic<bool> stop_{false};
    std::atomic<int64_t> kept_{0};
    mutable std::mutex problem_mutex_;  // never taken by the physics thread
    std::string problem_;
    // physics thread to recorder thread
    sim::Ring<sim::Input> inputs_;
    sim::Ring<sim::Sample> samples_;
    sim::Ring<sim::Event> events_;
    // recorder thread
    std::vector<sim::Input> input_block_;
    std::vector<sim::Sample> sample_block_;
    std::vector<sim::Event> event_block_;
};

}  // namespace placode::curriculum

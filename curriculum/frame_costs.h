// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the frames of an attempt cost in wall clock, and how many substeps that leaves room for.
// Physics thread only; allocates in the constructor alone. Private to curriculum.

#include <chrono>
#include <cstddef>
#include <vector>

namespace placode::curriculum {

class FrameCosts {
 public:
    using Clock = std::chrono::steady_clock;

    FrameCosts();
    void start(Clock::time_point now) noexcept { second_ = now; }
    /// One frame that took `cost` and ended at `now`.
    void add(Clock::duration cost, Clock::time_point now) noexcept;

    /// Substeps of the next frame, one more or one less than `substeps` at most: fewer (not below
    /// 2) when 200 frames on end took 95 % of the `frame_s` they stand for, more (not above
    /// `wanted`) when 2,000 on end left room for one more. Call once a frame. Only for hands: a
    /// script must give the same bits at any speed of the machine.
    [[nodiscard]] int adapted(int substeps, int wanted, double frame_s) noexcept;

    [[nodiscard]] double smoothed_s() const noexcept { return smoothed_s_; }  ///< Of one frame.
    // Both anew every second.
    [[nodiscard]] double frames_per_s() const noexcept { return frames_per_s_; }
    [[nodiscard]] double p99_ms() const noexcept { return p99_ms_; }  ///< Of 1,024 frames at most.

 private:
    void close_second(double elapsed_s) noexcept;

    Clock::time_point second_{};
    int second_frames_ = 0, slow_frames_ = 0, quick_frames_ = 0;
    double smoothed_s_ = 0, frames_per_s_ = 0, p99_ms_ = 0;
    std::vector<float> costs_ms_, sorted_ms_;
    size_t count_ = 0;
};

}  // namespace placode::curriculum

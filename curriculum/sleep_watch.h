// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Did the computer sleep in the middle of an attempt? CLOCK_MONOTONIC, by which everything else
// runs, stands still meanwhile: without this an attempt over lunch has no trace of it.

#include <cstdint>

namespace placode::curriculum {

/// Physics thread; never allocates.
class SleepWatch {
 public:
    /// @param asleep_ns haptics::asleep_ns() at the start; here and below.
    explicit SleepWatch(int64_t asleep_ns) noexcept : asleep_ns_(asleep_ns) {}

    /// @return seconds slept since the last sleep that it told of; 0 = up to a second.
    double look(int64_t asleep_ns) noexcept {
        const int64_t slept_ns = asleep_ns - asleep_ns_;
        if (slept_ns <= kLeastNs) return 0;
        asleep_ns_ = asleep_ns;
        const double slept_s = 1e-9 * static_cast<double>(slept_ns);
        total_s_ += slept_s;
        return slept_s;
    }
    [[nodiscard]] double total_s() const noexcept { return total_s_; }  ///< Of all that it told.

 private:
    static constexpr int64_t kLeastNs = 1'000'000'000;
    int64_t asleep_ns_;
    double total_s_ = 0;
};

}  // namespace placode::curriculum

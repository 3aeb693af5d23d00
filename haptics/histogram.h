// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Counts of durations for percentiles, filled by a real-time thread and read by any other: 5 us
// wide up to 5 ms, then 1 ms wide up to 1 s. One writer, any reader; no lock, no allocation.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>

namespace placode::haptics {

class DurationHistogram {
 public:
    void add(int64_t duration_ns) noexcept {
        const int64_t us = std::max<int64_t>(0, duration_ns / 1000);
        const int64_t bin =
            us < kFineUs
                ? us / kFineWidthUs
                : std::min<int64_t>(kFine + (us - kFineUs) / kCoarseWidthUs, kFine + kCoarse - 1);
        // One writer: a plain store is enough and never locks the bus.
        auto& count = counts_[static_cast<size_t>(bin)];
        count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        if (duration_ns > max_ns_.load(std::memory_order_relaxed))
            max_ns_.store(duration_ns, std::memory_order_relaxed);
    }
    /// Upper edge of the bin that holds the share `q` of all durations, never above the maximum
    /// [us]; 0 when there are none.
    [[nodiscard]] double quantile_us(double q) const noexcept {
        uint64_t total = 0, sum = 0;
        for (const auto& count : counts_) total += count.load(std::memory_order_relaxed);
        if (total == 0) return 0;
        for (int64_t bin = 0; bin < kFine + kCoarse; ++bin) {
            sum += counts_[static_cast<size_t>(bin)].load(std::memory_order_relaxed);
            if (static_cast<double>(sum) < q * static_cast<double>(total)) continue;
            const int64_t edge = bin < kFine ? (bin + 1) * kFineWidthUs
                                             : kFineUs + (bin - kFine + 1) * kCoarseWidthUs;
            return std::min(static_cast<double>(edge), max_us());
        }
        return max_us();
    }
    [[nodiscard]] double max_us() const noexcept {
        return static_cast<double>(max_ns_.load(std::memory_order_relaxed)) * 1e-3;
    }

 private:
    static constexpr int64_t kFine = 1000, kCoarse = 1000, kFineWidthUs = 5, kCoarseWidthUs = 1000,
                             kFineUs = kFine * kFineWidthUs;
    std::array<std::atomic<uint32_t>, kFine + kCoarse> counts_{};
    std::atomic<int64_t> max_ns_{0};
};

}  // namespace placode::haptics

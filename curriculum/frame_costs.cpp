// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/frame_costs.h"

#include <algorithm>

namespace placode::curriculum {

namespace {

constexpr int kFewestSubsteps = 2;
constexpr int kSlowFrames = 200, kQuickFrames = 2000;  // before the substeps change
constexpr double kSlowShare = 0.95, kRoomShare = 0.8;  // of the frame's time
constexpr double kSmoothing = 0.02;
constexpr size_t kCosts = 1024;

}  // namespace

FrameCosts::FrameCosts() : costs_ms_(kCosts, 0.0f), sorted_ms_(kCosts, 0.0f) {}

void FrameCosts::add(Clock::duration cost, Clock::time_point now) noexcept {
    const double seconds = std::chrono::duration<double>(cost).count();
    smoothed_s_ += kSmoothing * (seconds - smoothed_s_);
    costs_ms_[count_++ % kCosts] = static_cast<float>(seconds * 1e3);
    ++second_frames_;
    const double elapsed = std::chrono::duration<double>(now - second_).count();
    if (elapsed < 1) return;
    close_second(elapsed);
    second_ = now;
}

void FrameCosts::close_second(double elapsed_s) noexcept {
    frames_per_s_ = second_frames_ / elapsed_s;
    second_frames_ = 0;
    const size_t n = std::min(count_, kCosts);
    std::copy_n(costs_ms_.begin(), n, sorted_ms_.begin());
    const auto p99 = sorted_ms_.begin() + static_cast<long>((n - 1) * 99 / 100);
    std::nth_element(sorted_ms_.begin(), p99, sorted_ms_.begin() + static_cast<long>(n));
    p99_ms_ = *p99;
}

int FrameCosts::adapted(int substeps, int wanted, double frame_s) noexcept {
    slow_frames_ = smoothed_s_ > kSlowShare * frame_s ? slow_frames_ + 1 : 0;
    // One substep more must still fit, or the number would swing to and fro.
    const double room = kRoomShare * frame_s * substeps / (substeps + 1);
    quick_frames_ = smoothed_s_ < room ? quick_frames_ + 1 : 0;
    if (slow_frames_ >= kSlowFrames && substeps > std::min(kFewestSubsteps, wanted)) {
        slow_frames_ = 0;
        return substeps - 1;
    }
    if (quick_frames_ >= kQuickFrames && substeps < wanted) {
        quick_frames_ = 0;
        return substeps + 1;
    }
    return substeps;
}

}  // namespace placode::curriculum

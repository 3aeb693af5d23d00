// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether a team of threads pays, by trying: now and then some frames are done by turns with the
// team and by the caller alone, and the cheaper cost is kept until the next trial. Neither cores
// nor tetrahedra tell it beforehand: what one core has written the other has to fetch, and how dear
// that is depends on the machine and on how much of a frame is serial.

#include <algorithm>
#include <array>
#include <chrono>

namespace placode::sim {

/// Bits do not depend on who does a job, so the choice may change at any frame.
class TeamTrial {
 public:
    using Duration = std::chrono::steady_clock::duration;

    static constexpr int kKeep = 2000;  ///< Frames from one trial to the next.
    static constexpr int kTurn = 6;     ///< Frames of one cost in a row during a trial.
    static constexpr int kTurns = 4;    ///< Of either cost.
    static constexpr int kTrial = 2 * kTurns * kTurn;

    /// Whether the next frame is the caller's alone.
    [[nodiscard]] bool alone() const noexcept {
        return frame_ < 0 ? alone_ : frame_ / kTurn % 2 == 1;
    }
    /// A frame was done that cost, in this time. Allocates nothing.
    void done(Duration spent) noexcept {
        if (frame_ >= 0 && frame_ % kTurn >= kSettling) {
            Cost& cost = alone() ? alone_cost_ : team_cost_;
            cost.spent[cost.count++] = spent;
        }
        if (++frame_ == kTrial) decide();
    }

 private:
    static constexpr int kSettling = 2;  // of a turn: caches still hold what the other cost left
    static constexpr size_t kCounted = size_t{kTurns} * (kTurn - kSettling);
    static constexpr int kFirst = 200;  // frames before the first trial
    // Less than this is not worth a change.
    static constexpr double kGain = 0.05;

    struct Cost {
        std::array<Duration, kCounted> spent{};
        size_t count = 0;
        /// One frame that lost its core decides nothing.
        [[nodiscard]] double median() noexcept {
            std::nth_element(spent.begin(), spent.begin() + kCounted / 2, spent.end());
            return static_cast<double>(spent[kCounted / 2].count());
        }
    };

    void decide() noexcept {
        const double with_team = team_cost_.median(), without = alone_cost_.median();
        alone_ = alone_ ? with_team >= (1 - kGain) * without : without < (1 - kGain) * with_team;
        team_cost_.count = alone_cost_.count = 0;
        frame_ = -kKeep;
    }

    int frame_ = -kFirst;  // of the trial; below 0 = until the next one
    bool alone_ = false;
    Cost team_cost_, alone_cost_;
};

}  // namespace placode::sim

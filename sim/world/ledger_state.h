// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the ledger sums up over frames before it writes an event.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"
#include "sim/core/tissue.h"

namespace placode::sim {

struct Scene;
struct State;

/// A spell beyond the injury stretch counts from here on, then with its whole length [s].
inline constexpr double kOverStretchS = 0.05;
/// Which tets are beyond their injury stretch, since when, and what that comes to.
class OverStretch {
 public:
    OverStretch(int tets, double frame_s);
    /// A check found the tet beyond its limit. The time between two such checks in a row counts.
    void beyond(int tet, int64_t frame, double stretch, double volume_m3, Tissue tissue) noexcept;
    /// A check found it below.
    void below(int tet) noexcept { since_[static_cast<size_t>(tet)] = -1; }
    /// Tissue asleep keeps its stretch and is not checked: brings its spells up to this frame.
    void catch_up(const Scene& scene, const State& state) noexcept;

    struct Sum {
        double volume_time_m3_s = 0, stretch = 0;
        int32_t tet = -1;

        template <class Visit>
        friend void fields(Of<Sum> auto& s, Visit&& visit) {
            auto& [volume_time_m3_s, stretch, tet] = s;
            visit.state(volume_time_m3_s, stretch, tet);
        }
    };
    /// What came together since the last call, by tissue.
    [[nodiscard]] std::array<Sum, kTissueCount> take() noexcept;

 private:
    /// True when the spell is long enough to count.
    bool extend(int tet, int64_t frame, double volume_m3, Tissue tissue) noexcept;
    std::vector<int32_t> since_, last_;  // (T) frames; since -1 = not beyond
    std::array<Sum, kTissueCount> sum_{};
    double frame_s_;

    template <class Visit>
    friend void fields(Of<OverStretch> auto& s, Visit&& visit) {
        auto& [since, last, sum, frame_s] = s;
        visit.state(since, last, sum);
        visit.constant(frame_s);
    }
};

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the candidates of a frame come nearest to their instruments in a substep.

#include <array>

#include "sim/contact/contact.h"
#include "sim/core/float_lanes.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// A pose as columns of floats.
struct FloatPose {
    FloatPose() = default;
    explicit FloatPose(const Pose& pose) noexcept;
    [[nodiscard]] FloatLanes operator*(FloatLanes p) const noexcept {
        return column[0] * every_lane(p[0]) + column[1] * every_lane(p[1]) +
               column[2] * every_lane(p[2]) + origin;
    }
    std::array<FloatLanes, 3> column{};
    FloatLanes origin{};
};

/// Fills ContactSet::nearest, candidate by candidate: jobs for the team, since nothing else in a
/// frame but the solve has so many parts that touch nothing in common.
class NarrowPhase {
 public:
    /// From the poses of the instruments and the places at the substep's start.
    NarrowPhase(const Scene& scene, State& state) noexcept;
    [[nodiscard]] int jobs() const noexcept;
    void job(int number) noexcept;
    [[nodiscard]] const Pose& to_tool(int t) const noexcept {
        return to_tool_[static_cast<size_t>(t)];
    }

 private:
    [[nodiscard]] TriangleDistance nearest(int i) const noexcept;

    const Scene& scene_;
    const State& state_;
    ContactSet& set_;
    std::array<Pose, kMaxTools> to_tool_;
    std::array<FloatPose, kMaxTools> roughly_;
};

}  // namespace placode::sim

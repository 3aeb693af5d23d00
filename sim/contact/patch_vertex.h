// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One vertex of a patch against the face of the tissue that is next to it, for one substep.

#include <array>
#include <cstdint>

#include "sim/core/tool_shape.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// What one vertex of the patch makes the corners of a face bear.
struct PatchLoad {
    std::array<int32_t, 3> face;  ///< [0] = -1: nothing.
    std::array<Vec3, 3> force_n;
};

/// Depends on the substep's start alone: the same before and after the sweep. Different vertices
/// write nothing of each other.
class PatchVertex {
 public:
    /// @param number of the vertex in the patch. h [s].
    PatchVertex(const Scene& scene, State& state, int32_t number, double h) noexcept;

    /// Sets the spring of the substep.
    void press() noexcept;
    /// What the tissue bears after the last sweep; lets friction slip.
    void bear(PatchLoad& out) noexcept;

 private:
    void meet() noexcept;
    [[nodiscard]] Vec3 coasting() const noexcept;
    [[nodiscard]] Vec3 anchor_at(const Vec3& x) noexcept;
    [[nodiscard]] double load_of(const Vec3& x) const noexcept {
        return press_n_m_ * (overlap_at_ - n_.dot(x));
    }
    [[nodiscard]] Vec3 across(const Vec3& way) const noexcept { return way - n_ * n_.dot(way); }

    const Scene& scene_;
    const Patch& patch_;
    State& state_;
    PatchTouch& touch_;
    int32_t vertex_;
    double h_;
    double press_n_m_ = 0;   // along n_
    double overlap_at_ = 0;  // n_ . x below which it presses [m]
    bool touches_ = false;
    std::array<int32_t, 3> face_{};
    Triangle ahead_;   // its corners at the end of the substep
    Vec3 weight_, n_;  // nearest point of the face, and the way from there to the patch
};

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One vertex of a patch against the face of the tissue that is next to it, and against the patch
// itself, for one substep.

#include <array>
#include <cstdint>

#include "sim/core/as_index.h"
#include "sim/core/tool_shape.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {

/// Different vertices write nothing of each other.
class PatchVertex {
 public:
    /// @param number of the vertex in the patch. h [s].
    PatchVertex(const Scene& scene, State& state, int32_t number, double h) noexcept;

    /// Before the sweep: sets the spring of the substep, and its PatchTie.
    void press() noexcept;
    /// After it: PatchTie::load_n, and friction slips. @pre press() was called in this substep
    void bear() noexcept;

 private:
    void meet() noexcept;
    [[nodiscard]] bool stays_away(const Vec3& offset, const Vec3& turned) const noexcept;
    void hold() noexcept;
    void tie(const Mat3& k, const Vec3& place) noexcept;
    [[nodiscard]] double press_pa_m() const noexcept;
    [[nodiscard]] Vec3 coasting() const noexcept;
    [[nodiscard]] Vec3 find_anchor(const Vec3& x) noexcept;
    [[nodiscard]] double load_of(const Vec3& x) const noexcept {
        return tie_.press_n_m * (tie_.overlap_at_m - tie_.n.dot(x));
    }
    [[nodiscard]] Vec3 across(const Vec3& offset) const noexcept {
        return offset - tie_.n * tie_.n.dot(offset);
    }

    const Scene& scene_;
    const Patch& patch_;
    State& state_;
    PatchTouch& touch_;
    PatchTie& tie_;
    int32_t number_, vertex_;
    double h_;
};

}  // namespace placode::sim

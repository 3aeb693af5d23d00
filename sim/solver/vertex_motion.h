// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Begin and end of a substep one vertex at a time: what the kernels of motion leave over (to the
// same bits, motion_kernel-inl.h), bodies with external forces, and positions with low parts.
// Private to the solver.

#include "sim/solver/soft_body.h"
#include "sim/solver/soft_body_kernels.h"

namespace placode::sim {

class VertexMotion {
 public:
    VertexMotion(SoftBodyState& state, const MotionArguments& motion) noexcept
        : state_(state), motion_(motion) {}

    /// Neither external forces nor low parts: the kernels do.
    [[nodiscard]] bool plain() const noexcept { return state_.force_n.empty() && !keeps_low(); }

    /// x_start and start guess. Returns bits of StepReport.
    uint32_t begin(size_t i) noexcept;
    /// Velocity from the position. Returns bits of StepReport.
    uint32_t end(size_t i) noexcept;

 private:
    [[nodiscard]] bool keeps_low() const noexcept { return !state_.x_low.empty(); }
    void begin_low(size_t i) noexcept;
    [[nodiscard]] Float4 changed_low(size_t i, const Float4& base) const noexcept;
    [[nodiscard]] Float4 planned(size_t i, const Float4& v) const noexcept;
    [[nodiscard]] Float4 pushed_by_force(size_t i) const noexcept;
    [[nodiscard]] float scaled_sum(float scale, float a, float b) const noexcept;
    [[nodiscard]] Float4 guessed(const Float4& x, const Float4& u) const noexcept;

    SoftBodyState& state_;
    const MotionArguments& motion_;
};

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The heart: one frame of the simulated world. Keeps nothing, throws nothing, allocates nothing.
// The same scene, state and inputs give the same bits at any number of threads.

#include <array>
#include <cstdint>
#include <span>

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

struct StepReport {
    uint32_t flags = 0;  ///< StepFlag bits.
    int contacts = 0;
    int vaporised = 0;
    /// solve, contact, heat, cut, rest. Wall clock; never fed back into the state.
    std::array<int64_t, 5> cost_ns{};
};

/// Advances one frame. Inputs that are not finite count as not engaged; the body's settings say how
/// long a frame is, State::substeps into how many substeps it is cut. @pre inputs.size() ==
/// feedback.size() == scene.tools.size().
StepReport step(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                std::span<ToolFeedback> feedback) noexcept;

/// Lets the pre-tension and gravity settle without tools, for `seconds` of simulated time.
void settle(const Scene& scene, State& state, double seconds) noexcept;

/// Where the planned contour lies now (contour_anchors.size()), in W [m].
void deformed_contour(const Scene& scene, const State& state, std::span<Vec3> out) noexcept;

}  // namespace placode::sim

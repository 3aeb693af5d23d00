// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blades. When they begin to close, the faces of the mesh that lie nearest to the blades' plane
// between them are planned, in the order in which the crossing of the blades will reach them; while
// they close, the crossing runs from the hinge to the tips and parts the faces that it passes.
// Tissue that moves meanwhile is cut where the blades met it. Opening begins anew.
//
// Frame T: z distal, blades open along y, their plane is x = 0.

#include <array>
#include <cstdint>

#include "sim/geometry.h"
#include "sim/tissue.h"
#include "sim/tool.h"

namespace placode::sim {

struct Scene;
struct State;

inline constexpr int kMostPlanned = 1024;

/// One face that the blades are about to part.
struct PlannedFace {
    int32_t face = -1;  ///< 4 tet + local vertex opposite
    float z_m = 0;      ///< Along the blades, 0 at the tips.
};

/// One pair of blades.
struct Scissors {
    std::array<PlannedFace, kMostPlanned> planned{};
    int32_t planned_count = 0, next = 0;
    float jaw_rad = 0;    ///< Opening in the last frame.
    float start_rad = 0;  ///< Opening from which they close.
    uint8_t closing = 0;
    // The current snip, for the ledger.
    float area_m2 = 0, placode_m2 = 0, depth_m = 0;
    std::array<float, kTissueCount> area_of{};  ///< By tissue, where it was cut.
    Vec3 rest_sum = Vec3::Zero();
    int32_t faces = 0, tet = -1;
};

/// Blades that stand open are thin edges: they pass beside tissue instead of pushing it.
[[nodiscard]] bool blades_open(const Scene& scene, const State& state, int tool) noexcept;

/// Closed blades that lie in the gap of their own snip, as far as they know: they do not burst it.
[[nodiscard]] bool blades_in_cut(const Scene& scene, const State& state, int tool) noexcept;

/// One frame of all scissors; writes a finished snip into the ledger.
void run_scissors(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Jaws that hold tissue. Closing jaws take the vertices that lie between them; these are held in
// place in the jaws' frame, so that the hand carries them, and the force is read from the elastic
// residual of what they pull on. Friction of the jaw force holds up to 2 mu N; above that the
// tissue slides out. Too much pressure crushes, too much traction is noted, over-stretched tissue
// tears (sim/cutting.h).
//
// Frame T: z distal, jaws open along y (half the angle each), x across their width.

#include <array>
#include <cstdint>

#include "sim/geometry.h"
#include "sim/tissue.h"
#include "sim/tool.h"

namespace placode::sim {

struct Scene;
struct State;

inline constexpr int kMaxGrasped = 96;

/// A vertex between the jaws.
struct GraspedVertex {
    int32_t vertex = -1;
    std::array<float, 3> at_T{};  ///< Place in T, y as if the jaws still stood where they met it.
};

/// One pair of jaws. count == 0: holds nothing.
struct Grasp {
    std::array<GraspedVertex, kMaxGrasped> held{};
    int32_t count = 0;
    int32_t grasped = 0;           ///< Vertices when the jaws closed.
    float jaw_rad = 1;             ///< Opening in the last frame.
    float meet_rad = 0;            ///< Opening at which the jaws met the tissue.
    float pinch_n = 0;             ///< Jaw force N.
    float area_m2 = 0;             ///< Bitten area.
    float held_s = 0, peak_n = 0;  ///< Since the grasp; peak of the traction.
    float slip_m = 0;              ///< Way slipped in the current slip.
    float slip_pause_s = 0;        ///< Until a slip counts as ended.
    float slip_peak_n = 0;
    float traction_s = 0, traction_peak_n = 0;  ///< Current spell above the tissue's limit.
    Tissue tissue = Tissue::kSkin;              ///< Most of what is held.
    uint8_t shut = 0;     ///< The jaws have met (with or without tissue): open them to grasp anew.
    uint8_t crushed = 0;  ///< Crushing is in the ledger.
    Vec3 force_n = Vec3::Zero();    ///< Of the tissue on the jaws, mean over the last frame.
    std::array<float, 3> rest_m{};  ///< Where at rest.
    int32_t tet = -1;               ///< A tet there.
};

/// Angle below which jaws meet tissue of usual thickness [rad].
[[nodiscard]] double grip_angle(const ToolSpec& spec) noexcept;

/// Start of a substep, after the instruments moved: carries what is held.
void carry_grasped(const Scene& scene, State& state) noexcept;

/// End of a substep: force of the held tissue on the jaws; slips where friction does not hold it.
void feel_grasped(const Scene& scene, State& state) noexcept;

/// End of a frame of `dt` seconds: closes, opens, crushes, and writes what happened.
void update_grasps(const Scene& scene, State& state, double dt) noexcept;

/// A held vertex was split: the jaws hold its copy as well.
void hold_copy(const Scene& scene, State& state, int vertex, int copy) noexcept;

/// Takes a vertex out of any jaws (it died, or its tissue was cut away).
void let_go_vertex(const Scene& scene, State& state, int vertex) noexcept;

}  // namespace placode::sim

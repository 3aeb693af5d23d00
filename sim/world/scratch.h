// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Working memory of step(): sized once, reused every frame. Nothing in it decides the future: it
// may be built anew, or forgotten, between any two frames (tests/whole_state_test.cpp).

#include <array>
#include <vector>

#include "sim/solver/slide_vertex.h"
#include "sim/suture/needle_bonds.h"
#include "sim/world/contact_state.h"
#include "sim/world/cut_state.h"
#include "sim/world/patch_scratch.h"
#include "sim/world/pieces_state.h"
#include "sim/world/pool_flux.h"
#include "sim/world/state.h"

namespace placode::sim {

inline constexpr int kMostChoices = 256;

/// A vertex beside the plane of blades, and the shortest slide onto it.
struct SlideChoice {
    Slide slide;
    float shift_m = -1;  ///< At rest; negative = none.
};

struct State::Scratch {
    /// @param untouched gets the progress of the untouched body, found with the same tables.
    explicit Scratch(const Scene& scene, CutProgress* untouched = nullptr);
    /// As if built anew: after the state has become another one.
    void forget() noexcept;
    ContactSet contacts;
    CutTables cut;
    std::vector<int32_t> vaporised;        // room for one heat step
    std::vector<int32_t> candidates;       // (V) vertices near a current
    std::vector<float> placode_volume_m3;  // (V) share of the placode, constant
    PieceSearch pieces;
    FreePieces free_pieces;
    PatchScratch patch;
    std::vector<SutureScratch> suture;  // empty or one
    SutureReport suture_report;         // of this frame
    std::vector<Vec3> sac_thirds;       // (triangles of the sac) of this frame
    std::vector<int32_t> sector_stack;  // (T)
    std::vector<uint32_t> tet_seen;     // (T) stamps of a search
    uint32_t stamp = 0;
    std::vector<uint32_t> near_blade;  // (V + spares) stamps: looked at
    std::vector<SlideChoice> choices;  // of vertices beside closing blades
    std::array<int32_t, kMaxTools> tip_triangle{-1, -1, -1, -1};  // next to each tip, a frame ago
    double longest_edge_m = 0;                                    // at rest, constant
    bool heat_stepped = false;                                    // in this frame
    PoolFlux pool;                                                // of the last sweep
};

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Working memory of step(): sized once, reused every frame. Nothing in it decides the future.

#include <array>
#include <vector>

#include "sim/contact.h"
#include "sim/cut_columns.h"
#include "sim/damage.h"
#include "sim/pieces.h"
#include "sim/separation.h"
#include "sim/step.h"

namespace placode::sim {

struct State::Scratch {
    explicit Scratch(const Scene& scene);
    ContactSet contacts;
    CutTables cut;
    std::vector<int32_t> vaporised;        // room for one heat step
    std::vector<int32_t> candidates;       // (V) vertices near a current
    std::vector<float> placode_volume_m3;  // (V) share of the placode, constant
    std::vector<uint8_t> tether_alive;     // before the frame
    SeparationQueue separation;
    PieceSearch pieces;
    std::vector<Vec3> sac_thirds;       // (triangles of the sac) of this frame
    std::vector<int32_t> sector_stack;  // (T)
    std::vector<uint32_t> tet_seen;     // (T) stamps of a search
    uint32_t stamp = 0;
    OverStretch over_stretch;
    std::vector<uint8_t> gone_by_heat;                            // (T) 1 = vaporised
    std::array<int32_t, kMaxTools> tip_triangle{-1, -1, -1, -1};  // next to each tip, a frame ago
    double longest_edge_m = 0;                                    // at rest, constant
    bool heat_stepped = false;                                    // in this frame
};

}  // namespace placode::sim

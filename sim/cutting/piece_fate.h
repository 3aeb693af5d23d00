// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What becomes of a piece that has come loose: it sticks where it lies, hangs in jaws, falls, is
// drawn out through the port or washed away. For pieces.cpp, which finds the pieces.

#include <algorithm>
#include <cmath>

#include "sim/world/add_event.h"
#include "sim/world/pieces_state.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

inline constexpr int kGroundCells = 64;       ///< Heightmap of cells around the lesion,
inline constexpr double kGroundCell = 0.001;  ///< each so wide [m].

/// Cell of the heightmap in which a place lies; its border for what lies outside.
inline int ground_cell(double x, double y) noexcept {
    const auto cell = [](double c) {
        return std::clamp(static_cast<int>(std::floor(c / kGroundCell)) + kGroundCells / 2, 0,
                          kGroundCells - 1);
    };
    return cell(x) * kGroundCells + cell(y);
}

/// Visits the living tets of a piece.
template <class Visit>
void for_tets_of_piece(const Scene& scene, const State& state, int piece, Visit&& visit) noexcept {
    for (int32_t t = 0; t < scene.body.tet_count(); ++t) {
        if (state.pieces.of[t] == piece && state.body.tet_alive[t]) visit(t);
    }
}

/// Sticks where it is, or comes off.
void stick_piece(const Scene& scene, State& state, int piece, bool resting) noexcept;

/// Tool whose jaws hold the piece, -1 = none.
[[nodiscard]] int holder_of_piece(const Scene& scene, const State& state, int piece) noexcept;

/// An event of `kind` with the place, volume and holder of `p`.
[[nodiscard]] Event piece_event(const Scene& scene, const State& state, EventKind kind,
                                const Piece& p) noexcept;

/// Tissue that nobody was to remove and that leaves with a piece is lost like what tears: a kTorn
/// for each kind, with all of its rest volume and no stretch, at the first of its tets. Placode and
/// healthy skin always; all kinds where no tissue is marked and no instrument cuts.
void note_lost_tissue(const Scene& scene, State& state, int piece) noexcept;

/// One frame of a piece that has been found.
void follow_piece(const Scene& scene, State& state, int piece) noexcept;

}  // namespace placode::sim

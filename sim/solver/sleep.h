// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue that is at rest and away from instruments is not solved. The vertices are cut into blocks
// that stay together in space. A block falls asleep when all of it has been calm for a while, and
// wakes when an instrument, a cut or a grasp comes near or when its neighbours have moved since it
// fell asleep. What sleeps keeps its place exactly and has no velocity, so that neither falling
// asleep nor waking can be seen; the price is that motions below `kWakeM` end at its border.
//
// VBD leaves out batches of vertices, XPBD batches of tets that touch only what sleeps; in the
// others what sleeps is held (hold_sleepers()). xpbd_pair trembles at rest too much to sleep.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/fields.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

class SurfaceTree;

inline constexpr int kChunk = 16;  ///< Vertices, as AwakeRuns::vertices.

/// Sized by the constructor, never grows.
struct Sleep {
    explicit Sleep(const SoftBody& body);

    /// XPBD: learns which batches of tets move which blocks.
    void list_tets(const SoftBody& body);
    /// Learns which blocks lie in which leaf of the surface's tree.
    void follow_leaves(const SurfaceTree& tree, const TetMesh& mesh);

    [[nodiscard]] bool enabled() const noexcept { return !calm.empty(); }
    [[nodiscard]] int blocks() const noexcept { return static_cast<int>(calm.size()); }
    /// True while nothing at all is solved.
    [[nodiscard]] bool still() const noexcept { return asleep_count == blocks() && enabled(); }
    /// True when no corner of a tet moves.
    [[nodiscard]] bool sleeps(const std::array<int32_t, 4>& corners) const noexcept {
        for (const int32_t v : corners) {
            if (vertex_asleep[static_cast<size_t>(v)] == 0) return false;
        }
        return true;
    }

    // constant
    std::vector<int32_t> block;                   ///< (V) -1 = none: fixed, tethered.
    std::vector<int32_t> member_start, member;    ///< Vertices of a block.
    std::vector<int32_t> border_start, border;    ///< Movable vertices next to a block.
    std::vector<int32_t> unblocked;               ///< Movable vertices without a block.
    std::vector<int32_t> leaf_start, leaf_block;  ///< Blocks in a node of the surface's tree;
                                                  ///< `blocks()` stands for what has none.
    /// XPBD: tet batches with vertices of a block; behind the last block those with unblocked ones.
    std::vector<int32_t> tets_start, tets;

    // changing
    std::vector<uint8_t> asleep, calm;         ///< (blocks) calm: looks in a row.
    std::vector<uint8_t> restless;             ///< (blocks) 1 = was cut and never sleeps again.
    std::vector<uint8_t> near_awake;           ///< (blocks) 1 = asleep, with awake neighbours.
    std::vector<std::array<float, 3>> since;   ///< (members) where they were when calm began.
    std::vector<std::array<float, 3>> before;  ///< (borders) where they were when it fell asleep.
    std::vector<uint8_t> vertex_asleep;        ///< (V + spares) 1 = not solved, or fixed.
    std::vector<uint8_t> leaf_moves;  ///< (nodes of the surface's tree) 1 = has awake vertices.
    std::vector<uint8_t> chunk;       ///< (ceil((V + spares) / 16)) private.
    std::vector<uint8_t> tets_move;   ///< (tet batches) private.
    int asleep_count = 0;
    int32_t known_vertices = 0;  ///< Copies up to here have been looked at.
};
template <class Visit>
void fields(Of<Sleep> auto& s, Visit&& visit) {
    auto& [block, member_start, member, border_start, border, unblocked, leaf_start, leaf_block,
           tets_start, tets, asleep, calm, restless, near_awake, since, before, vertex_asleep,
           leaf_moves, chunk, tets_move, asleep_count, known_vertices] = s;
    visit.state(asleep, calm, restless, since, before, asleep_count, known_vertices);
    visit.kept(vertex_asleep, leaf_moves, chunk, tets_move, near_awake);
    visit.constant(block, member_start, member, border_start, border, unblocked, leaf_start,
                   leaf_block, tets_start, tets);
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/pieces.h"

#include <algorithm>

#include "sim/cutting/attempt_progress.h"
#include "sim/cutting/linked_tets.h"
#include "sim/cutting/piece_fate.h"
#include "sim/cutting/release.h"
#include "sim/solver/topology.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kFloodPerFrame = 2500;
constexpr int8_t kParted = -2;          // of a piece that was cut: belongs to none for a moment
constexpr double kCrumb = 0.3e-9;       // smaller pieces are washed away [m^3]
constexpr double kSunkenWall = 0.0005;  // thickness of a sac's wall that lies on the floor [m]

/// Whether a part of a piece lies where the piece did: its vertices are still held there.
bool rests(const Scene& scene, const State& state, int32_t tet) noexcept {
    for (const int32_t v : corners(scene.body, state.body, tet))
        if (state.pieces.resting[static_cast<size_t>(v)] == 0) return false;
    return true;
}

/// Gathers a piece from one of its tets and decides what becomes of it. What has come loose sticks
/// where it is; a part of a piece that was loose before goes on resting or falling.
void found(const Scene& scene, State& state, int32_t seed) noexcept {
    Pieces& pieces = state.pieces;
    const bool part = pieces.of[seed] == kParted;
    int slot = 0;
    while (slot < kMostPieces && pieces.list[slot].tets > 0) ++slot;
    if (slot == kMostPieces) return;  // found by the next flood: the piece that goes begins one
    std::vector<int32_t>& stack = state.scratch->sector_stack;
    Piece& p = pieces.list[slot];
    p = {};
    p.seed = seed;
    int32_t top = 0;
    stack[top++] = seed;
    pieces.of[seed] = static_cast<int8_t>(slot);
    while (top > 0) {
        const int32_t t = stack[--top];
        ++p.tets;
        p.volume_m3 += static_cast<double>(scene.body.volume_m3()[t]);
        for_linked(
            scene, state, t, [&](int32_t other) noexcept { return pieces.of[other] == slot; },
            [&](int32_t other) noexcept {
                pieces.of[other] = static_cast<int8_t>(slot);
                stack[top++] = other;
            });
    }
    p.held_by = static_cast<int8_t>(holder_of_piece(scene, state, slot));
    p.resting = part && rests(scene, state, seed) ? 1 : 0;
    if (p.volume_m3 < kCrumb && p.held_by < 0) {
        p.leaving = kWashedAway;
        ++pieces.crumbs;
        add_event(state, piece_event(scene, state, EventKind::kCrumb, p));
        note_lost_tissue(scene, state, slot);
        return;
    }
    add_event(state, piece_event(scene, state, EventKind::kPieceFree, p));
    if (p.held_by < 0 && !part) stick_piece(scene, state, slot, true);
}

/// What of a piece no longer hangs together with its first tet is a piece of its own: it loses its
/// number, and found() gives it another.
void part_pieces(const Scene& scene, State& state) noexcept {
    PieceSearch& search = state.scratch->pieces;
    std::vector<int32_t>& stack = state.scratch->sector_stack;
    for (int i = 0; i < kMostPieces; ++i) {
        if (state.pieces.list[i].tets == 0 || state.pieces.list[i].leaving) continue;
        const uint32_t stamp = ++search.sector_stamp;
        auto& seen = search.sector_seen;
        int32_t top = 0;
        bool begun = false;
        for_tets_of_piece(scene, state, i, [&](int32_t t) {
            if (begun && seen[t] != stamp) {
                state.pieces.of[t] = kParted;
                return;
            }
            if (begun) return;
            begun = true;
            seen[t] = stamp;
            stack[top++] = t;
            while (top > 0)
                for_linked(
                    scene, state, stack[--top],
                    [&](int32_t other) noexcept { return seen[other] == stamp; },
                    [&](int32_t other) noexcept {
                        seen[other] = stamp;
                        stack[top++] = other;
                    });
        });
    }
}

/// How many tets each piece has now: some of it may have burned or become another.
void count_again(const Scene& scene, State& state) noexcept {
    Pieces& pieces = state.pieces;
    for (int i = 0; i < kMostPieces; ++i) {
        Piece& p = pieces.list[i];
        if (p.tets == 0 || p.leaving) continue;
        int32_t tets = 0;
        double volume = 0;
        for_tets_of_piece(scene, state, i, [&](int32_t t) {
            ++tets;
            volume += static_cast<double>(scene.body.volume_m3()[t]);
            p.seed = t;
        });
        p.tets = tets;
        p.volume_m3 = volume;
    }
}

/// What hangs on a living strand is not loose: roots hold the placode over an opened sac.
void reach_tethered(const Scene& scene, State& state) noexcept {
    PieceFlood& flood = state.flood;
    const auto& tethers = scene.body.spec().tethers;
    for (size_t i = 0; i < tethers.size(); ++i) {
        if (!state.body.tether_alive[i]) continue;
        for (const int32_t v : tethers[i].vertex) {
            for (const int32_t t : tets_around(scene.body, state.body, v)) {
                if (!state.body.tet_alive[t] || flood.reached[t] == flood.stamp) continue;
                flood.reached[t] = flood.stamp;
                flood.stack[flood.top++] = t;
            }
        }
    }
}

/// Some frames' worth of flood from the bed; at its end what was not reached is loose.
void flood_from_bed(const Scene& scene, State& state) noexcept {
    PieceFlood& flood = state.flood;
    Pieces& pieces = state.pieces;
    if (!flood.running) {
        if (pieces.searched == state.surface.version()) return;
        pieces.searched = state.surface.version();
        flood.running = 1;
        flood.top = 0;
        ++flood.stamp;
        for (const int32_t t : state.scratch->pieces.anchored) {
            if (!state.body.tet_alive[t]) continue;
            flood.reached[t] = flood.stamp;
            flood.stack[flood.top++] = t;
        }
        reach_tethered(scene, state);
    }
    for (int n = 0; n < kFloodPerFrame && flood.top > 0; ++n) {
        const int32_t t = flood.stack[--flood.top];
        for_linked(
            scene, state, t,
            [&](int32_t other) noexcept { return flood.reached[other] == flood.stamp; },
            [&](int32_t other) noexcept {
                flood.reached[other] = flood.stamp;
                flood.stack[flood.top++] = other;
            });
    }
    if (flood.top > 0) return;
    flood.running = 0;
    bool any = false;
    part_pieces(scene, state);
    for (int32_t t = 0; t < scene.body.tet_count(); ++t) {
        if (!state.body.tet_alive[t] || flood.reached[t] == flood.stamp) continue;
        if (pieces.of[t] >= 0) continue;
        found(scene, state, t);
        any = true;
    }
    count_again(scene, state);
    if (any) update_free_vertices(scene.body, state.body);
}

}  // namespace

PieceSearch::PieceSearch(const Scene& scene)
    : ground_m(static_cast<size_t>(kGroundCells) * kGroundCells, -1.0F),
      sector_seen(scene.body.tet_count(), 0),
      sector_of_tet(scene.body.tet_count(), 0),
      path(kSectors),
      reached_by(scene.body.tet_count(), -1) {
    const TetMesh& mesh = scene.body.mesh();
    std::vector<uint8_t> held(mesh.rest.size(), 0);
    for (const int32_t v : scene.body.spec().fixed) held[v] = 1;
    for (const int32_t v : scene.body.packed().spring_vertices) held[v] = 1;
    std::array<std::vector<int32_t>, kSectors> sectors;
    for (int32_t t = 0; t < scene.body.tet_count(); ++t) {
        const auto& c = mesh.tets[t];
        if (std::any_of(c.begin(), c.end(), [&](int32_t v) { return held[v] != 0; })) {
            anchored.push_back(t);
        }
        sector_of_tet[t] = static_cast<int8_t>(sim::sector_of(rest_centroid(scene, t)));
        if (mesh.tissue[t] == Tissue::kPlacode) sectors[sector_of_tet[t]].push_back(t);
    }
    for (const auto& list : sectors) {
        sector_start.push_back(static_cast<int32_t>(sector_tets.size()));
        sector_tets.insert(sector_tets.end(), list.begin(), list.end());
    }
    sector_start.push_back(static_cast<int32_t>(sector_tets.size()));
    for (const Vec3& x : mesh.rest) {
        float& height = ground_m[ground_cell(x.x(), x.y())];
        // An opened sac does not stand: what falls lies on the canal's floor.
        const double floor = scene.sac.present() ? scene.sac.floor.at(x.x(), x.y()) : -1;
        const double z = floor > -0.1 ? floor + kSunkenWall : x.z();
        height = std::max(height, static_cast<float>(z));
    }
}

void update_pieces(const Scene& scene, State& state) noexcept {
    if (!scene.geometry.planned_contour.empty()) update_release(scene, state);
    update_outline(scene, state);
    // Where nothing is held, nothing can come loose.
    if (!state.body.topology || state.scratch->pieces.anchored.empty()) return;
    flood_from_bed(scene, state);
    for (int i = 0; i < kMostPieces; ++i) {
        if (state.pieces.list[i].tets > 0) follow_piece(scene, state, i);
    }
}

}  // namespace placode::sim

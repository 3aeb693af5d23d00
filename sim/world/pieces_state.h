// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What has come loose, how far the placode is released, and the search for both.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"

namespace placode::sim {

struct Scene;

inline constexpr int kSectors = 72;
inline constexpr int kMostPieces = 64;
inline constexpr uint8_t kWashedAway = 1, kDrawnOut = 2;  ///< Piece::leaving.

/// Which sectors of the placode are free.
struct ReleaseProgress {
    std::array<uint8_t, kSectors> free{};
    std::array<uint32_t, kSectors> checked{};  ///< Surface version of the last look.
    int32_t free_count = 0, next = 0;
};
template <class Visit>
void fields(Of<ReleaseProgress> auto& s, Visit&& visit) {
    auto& [free, checked, free_count, next] = s;
    visit.state(free, checked, free_count, next);
}

/// Where the outline of the marked tissue is parted. One point a frame.
struct ResectionProgress {
    std::vector<uint8_t> cut;       ///< Per point of Resection::line.
    std::vector<uint32_t> checked;  ///< Surface version of the last look.
    int32_t cut_count = 0, next = 0;
};
template <class Visit>
void fields(Of<ResectionProgress> auto& s, Visit&& visit) {
    auto& [cut, checked, cut_count, next] = s;
    visit.state(cut, checked, cut_count, next);
}

/// A piece of tissue that nothing but jaws holds.
struct Piece {
    double volume_m3 = 0;
    int32_t tets = 0;     ///< 0 = slot not in use.
    int32_t seed = -1;    ///< One of its tets.
    int8_t held_by = -1;  ///< Tool that holds it.
    uint8_t resting = 0;  ///< Sticks where it lies.
    uint8_t leaving = 0;  ///< Being taken away: kWashedAway (a crumb) or kDrawnOut; 0 = stays.
    uint16_t calm = 0;    ///< Frames that it has lain on other tissue without moving.
};
template <class Visit>
void fields(Of<Piece> auto& s, Visit&& visit) {
    auto& [volume_m3, tets, seed, held_by, resting, leaving, calm] = s;
    visit.state(volume_m3, tets, seed, held_by, resting, leaving, calm);
}

/// Loose tissue and the running flood.
struct Pieces {
    std::array<Piece, kMostPieces> list{};
    std::vector<int8_t> of;        ///< (T) Index into `list`, -1 = hangs on the bed. Sized once.
    std::vector<uint8_t> resting;  ///< (V + spares) Held by stickiness only.
    uint32_t searched = 0;         ///< Surface version at the start of the last flood.
    int32_t out = 0, crumbs = 0;
    double out_m3 = 0;
    double marked_gone_m3 = 0;  ///< Of Scene::marked, however it went.
    double marked_out_m3 = 0;   ///< Of that, in pieces that were drawn out, counted as they go.
    double marked_lost_m3 = 0;  ///< And what heat, force or water took.
};
template <class Visit>
void fields(Of<Pieces> auto& s, Visit&& visit) {
    auto& [list, of, resting, searched, out, crumbs, out_m3, marked_gone_m3, marked_out_m3,
           marked_lost_m3] = s;
    visit.state(list, of, resting, searched, out, crumbs, out_m3, marked_gone_m3, marked_out_m3,
                marked_lost_m3);
}

/// The running flood from the bed. Sized once.
struct PieceFlood {
    std::vector<uint32_t> reached;  ///< (T) stamps
    std::vector<int32_t> stack;     ///< (T) first `top`
    uint32_t stamp = 0;
    int32_t top = 0;
    uint8_t running = 0;
};
template <class Visit>
void fields(Of<PieceFlood> auto& s, Visit&& visit) {
    auto& [reached, stack, stamp, top, running] = s;
    visit.state(reached, stack, stamp, top, running);
}

/// Loose pieces that nothing holds and nothing else moves with, found anew in every frame
/// (sim/contact/free_pieces.h). Sized once; empty in a body that cannot be cut.
struct FreePieces {
    explicit FreePieces(const Scene& scene);
    /// As if built anew.
    void forget() noexcept;

    struct Body {
        int32_t first = 0, count = 0;  ///< Into `vertex`; 0 = does not move freely.
        double edge_m = 0;             ///< Longest of its vertices' shortest edges.
    };
    std::array<Body, kMostPieces> bodies{};  ///< By the number of the piece. Valid while `any`.
    std::vector<int32_t> vertex;             ///< (V + spares) Piece by piece.
    std::vector<int32_t> found;              ///< (V + spares) First `found_count`.
    std::vector<int8_t> of;                  ///< (V + spares) Number of the piece, -1 = of none.
    int32_t found_count = 0;
    bool any = false;
};

/// Constant lists, and paths that were found: lost, they are found again. Sized once.
struct PieceSearch {
    explicit PieceSearch(const Scene& scene);
    std::vector<int32_t> sector_start, sector_tets;  // tets that count for the release, by sector
    std::vector<int32_t> anchored;                   // tets at the bed
    std::vector<float> ground_m;                     // height of the field at rest, 1 mm cells
    uint32_t sector_stamp = 0;
    std::vector<uint32_t> sector_seen;  // (T) stamps
    std::vector<int8_t> sector_of_tet;  // (T)
    // A path that was found in a sector holds it until one of its links goes.
    static constexpr int kLongestPath = 64;
    struct Path {
        std::array<int32_t, kLongestPath> tet;
        int count = 0;
    };
    std::vector<Path> path;           // by sector
    std::vector<int32_t> reached_by;  // (T) tet from which it was reached
};

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/free_pieces.h"

#include <algorithm>
#include <array>

#include "sim/contact/whole_body.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kPieceLongest = 0.25;  // of an edge, in a substep
constexpr double kPieceSettled = 1e-5;  // of an edge: what such a step leaves is its square
constexpr int kPiecePasses = 3;         // Newton's, where contacts open or close
// Of det / trace^3 of the inertia, 1/27 of a ball. A rod with 1/250 of its length as radius has
// less: rounding would spin it.
constexpr double kPieceThin = 1e-5;

using PieceMarks = std::array<bool, kMostPieces>;

bool any_of(const PieceMarks& marks) noexcept {
    return std::any_of(marks.begin(), marks.end(), [](bool mark) { return mark; });
}

/// Lists the vertices of the pieces that may move, and takes back what does not.
class PieceLists {
 public:
    PieceLists(const Scene& scene, State& state, PieceMarks& moves) noexcept
        : scene_(scene), state_(state), free_(state.scratch->free_pieces), moves_(moves) {}

    void list() noexcept {
        free_.bodies = {};
        for (int32_t t = 0; t < scene_.body.tet_count(); ++t) {
            const int8_t piece = state_.pieces.of[as_index(t)];
            if (piece < 0 || !moves_[as_index(piece)] || state_.body.tet_alive[as_index(t)] == 0)
                continue;
            for (const int32_t v : corners(scene_.body, state_.body, t)) add(v, piece);
        }
        sort();
    }

 private:
    void add(int32_t v, int8_t piece) noexcept {
        int8_t& of = free_.of[as_index(v)];
        if (of == piece) return;
        if (of >= 0) {  // parted faces whose vertices still wait: two pieces hang on one
            moves_[as_index(of)] = moves_[as_index(piece)] = false;
            return;
        }
        if (state_.body.x[as_index(v)].w == 0 || state_.body.free_vertex[as_index(v)] != 1 ||
            state_.sleep.vertex_asleep[as_index(v)] != 0)
            moves_[as_index(piece)] = false;
        of = piece;
        free_.found[as_index(free_.found_count++)] = v;
        FreePieces::Body& body = free_.bodies[as_index(piece)];
        ++body.count;
        const float edge = scene_.body.shortest_edge_m()[as_index(origin_of(state_.body, v))];
        body.edge_m = std::max(body.edge_m, static_cast<double>(edge));
    }
    /// Piece by piece, each in the order of its tets.
    void sort() noexcept {
        std::array<int32_t, kMostPieces> end{};
        int32_t first = 0;
        for (size_t i = 0; i < free_.bodies.size(); ++i) {
            FreePieces::Body& body = free_.bodies[i];
            if (!moves_[i]) body.count = 0;
            body.first = end[i] = first;
            first += body.count;
        }
        for (int32_t i = 0; i < free_.found_count; ++i) {
            const int32_t v = free_.found[as_index(i)];
            const auto piece = as_index(free_.of[as_index(v)]);
            if (moves_[piece]) free_.vertex[as_index(end[piece]++)] = v;
        }
        free_.any = first > 0;
    }

    const Scene& scene_;
    State& state_;
    FreePieces& free_;
    PieceMarks& moves_;
};

class PieceModes {
 public:
    PieceModes(const Scene& scene, State& state, int piece, double h) noexcept
        : scene_(scene),
          state_(state),
          free_(state.scratch->free_pieces),
          body_(free_.bodies[as_index(piece)]),
          piece_(piece),
          h_(h),
          fall_m_s_(h * scene.body.spec().solver.gravity_m_s2),
          from_(to_vec(state.body.x_start[as_index(vertex(0))])) {}

    /// @param touched instruments may press on it.
    void move(bool touched) noexcept {
        for (int pass = 0; pass < (touched ? kPiecePasses : 1); ++pass) {
            const auto step = next_step(touched);
            if (!step) return;
            const double way =
                move_whole(state_.body, from_, *step, body_.count, kPieceLongest * body_.edge_m,
                           [&](int32_t i) noexcept { return vertex(i); });
            if (way < kPieceSettled * body_.edge_m) return;
        }
    }

 private:
    [[nodiscard]] int32_t vertex(int32_t i) const noexcept {
        return free_.vertex[as_index(body_.first + i)];
    }
    [[nodiscard]] bool owns(int32_t v) const noexcept { return free_.of[as_index(v)] == piece_; }

    [[nodiscard]] std::optional<WholeStep> next_step(bool touched) const noexcept {
        const SoftBodyState& body = state_.body;
        WholeSums sums;
        for (int32_t i = 0; i < body_.count; ++i) {
            const auto v = as_index(vertex(i));
            sums.add(static_cast<double>(mass_of(scene_.body, body, vertex(i))),
                     to_vec(body.x[v]) - from_, to_vec(body.x_start[v]) - from_,
                     h_ * (to_vec(body.v[v]) + fall_m_s_));
        }
        if (!(sums.mass_kg > 0)) return std::nullopt;
        Pushes pushes;
        if (touched) {
            // Friction goes by the loads of the present places, as it will be felt.
            weigh_contacts(state_.scratch->contacts, body,
                           [](const Contact&, double, double) noexcept {});
            add_instruments(
                state_.scratch->contacts, body, from_, h_ * h_,
                [&](int32_t v) noexcept { return owns(v); }, pushes);
        }
        const Mat3 inertia = sums.inertia - inertia_of(sums.mass_kg, sums.place / sums.mass_kg);
        const double trace = inertia.trace();
        const bool turns = inertia.determinant() > kPieceThin * trace * trace * trace;
        return whole_step(sums, pushes, turns);
    }

    const Scene& scene_;
    State& state_;
    const FreePieces& free_;
    const FreePieces::Body& body_;
    int piece_;
    double h_;
    Vec3 fall_m_s_, from_;  // all places are from there
};

/// Pieces with a contact, and pieces that lie on tissue or that needle or thread go through.
void mark_touched(const State& state, PieceMarks& touched, PieceMarks& left_alone) noexcept {
    const FreePieces& free = state.scratch->free_pieces;
    const auto mark = [&](int32_t v, PieceMarks& marks) noexcept {
        const int8_t piece = free.of[as_index(v)];
        if (piece >= 0) marks[as_index(piece)] = true;
    };
    const ContactSet& set = state.scratch->contacts;
    for (int32_t i = 0; i < set.vertex_count; ++i) mark(set.vertices[as_index(i)].vertex, touched);
    // What lies on other tissue is left to it: moved as a whole it did not come to rest.
    for (int32_t i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[as_index(i)];
        if (c.side != kTissueSide || gap_of(c, state.body) >= 0) continue;
        for (const int32_t v : c.vertex) mark(v, left_alone);
    }
    for (const SutureScratch& lists : state.scratch->suture) {
        for (int32_t i = 0; i < lists.colour_count; ++i)
            mark(lists.colour[as_index(i)].vertex, left_alone);
    }
}

}  // namespace

void collect_free_pieces(const Scene& scene, State& state) noexcept {
    if (!state.body.topology) return;
    FreePieces& free = state.scratch->free_pieces;
    for (int32_t i = 0; i < free.found_count; ++i) free.of[as_index(free.found[as_index(i)])] = -1;
    free.found_count = 0;
    free.any = false;
    PieceMarks moves{};
    for (size_t i = 0; i < moves.size(); ++i) {
        const Piece& p = state.pieces.list[i];
        moves[i] = p.tets > 0 && p.resting == 0 && p.leaving == 0 && p.held_by < 0;
    }
    if (any_of(moves)) PieceLists(scene, state, moves).list();
}

void move_free_pieces(const Scene& scene, State& state, double h) noexcept {
    const FreePieces& free = state.scratch->free_pieces;
    if (!free.any) return;
    PieceMarks touched{}, left_alone{};
    mark_touched(state, touched, left_alone);
    for (int piece = 0; piece < kMostPieces; ++piece) {
        if (free.bodies[as_index(piece)].count == 0 || left_alone[as_index(piece)]) continue;
        PieceModes(scene, state, piece, h).move(touched[as_index(piece)]);
    }
}

}  // namespace placode::sim

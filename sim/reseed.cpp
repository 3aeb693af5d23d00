// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The one state that no method leaves by itself: tissue shrunk to a point. F = 0 there, so that the
// gradients of |F|^2 and of J are both zero.

#include "sim/event.h"
#include "sim/soft_body.h"

namespace placode::sim {
namespace {

constexpr double kCollapsed = 1e-3;  // of the rest length; a working solver never comes near
constexpr uint8_t kSeen = 2;         // in free_vertex, for the time of the search

size_t at(int64_t i) { return static_cast<size_t>(i); }

Vec3 to_vec(const Float4& p) { return {p.x, p.y, p.z}; }

bool collapsed(const SoftBody& body, const SoftBodyState& state, int tet) noexcept {
    if (state.tet_alive[at(tet)] == 0) return false;
    const auto &k = corners(body, state, tet), &r = body.mesh().tets[at(tet)];
    for (size_t i = 1; i < 4; ++i) {
        for (size_t j = 0; j < i; ++j) {
            const double now = (to_vec(state.x[at(k[i])]) - to_vec(state.x[at(k[j])])).norm();
            const double rest = (body.mesh().rest[at(r[i])] - body.mesh().rest[at(r[j])]).norm();
            if (!(now < kCollapsed * rest)) return false;
        }
    }
    return true;
}

/// Means over a piece. Held vertices, where there are some, say alone where it belongs.
struct Piece {
    Vec3 moved = Vec3::Zero(), held_moved = Vec3::Zero(), velocity = Vec3::Zero();
    int vertices = 0, held = 0;

    void add(const Vec3& rest, const Float4& x, const Float4& v) noexcept {
        moved += to_vec(x) - rest;
        velocity += to_vec(v);
        ++vertices;
        if (x.w > 0) return;
        held_moved += to_vec(x) - rest;
        ++held;
    }
};

}  // namespace

int reseed_collapsed(const SoftBody& body, SoftBodyState& state) noexcept {
    int placed = 0;
    for (int t = 0; t < body.tet_count(); ++t) {
        if (!collapsed(body, state, t)) continue;
        size_t count = 0;  // of the piece, listed in scratch
        const auto reach = [&](int32_t v) {
            if ((state.free_vertex[at(v)] & kSeen) != 0) return;
            state.free_vertex[at(v)] |= kSeen;
            state.scratch[count++] = v;
        };
        for (const int32_t v : corners(body, state, t)) reach(v);
        for (size_t head = 0; head < count; ++head) {
            for (const int32_t other : tets_around(body, state, state.scratch[head])) {
                if (!collapsed(body, state, other)) continue;
                for (const int32_t v : corners(body, state, other)) reach(v);
            }
        }
        Piece piece;
        for (size_t i = 0; i < count; ++i) {
            const size_t v = at(state.scratch[i]);
            piece.add(body.mesh().rest[at(origin_of(state, static_cast<int>(v)))], state.x[v],
                      state.v[v]);
            state.free_vertex[v] &= static_cast<uint8_t>(~kSeen);
        }
        const Vec3 way = piece.held > 0 ? Vec3(piece.held_moved / piece.held)
                                        : Vec3(piece.moved / piece.vertices);
        const Vec3 velocity = piece.velocity / piece.vertices;
        for (size_t i = 0; i < count; ++i) {
            const size_t v = at(state.scratch[i]);
            if (state.x[v].w == 0) continue;
            const int32_t o = origin_of(state, static_cast<int>(v));
            const Vec3f x = (body.mesh().rest[at(o)] + way).cast<float>();
            const Vec3f u = velocity.cast<float>();
            state.x[v] = {x.x(), x.y(), x.z(), state.x[v].w};
            state.v[v] = {u.x(), u.y(), u.z(), 0};
            ++placed;
        }
    }
    if (placed > 0) {
        state.flags |= kReseed;
        rouse_all(state);
    }
    return placed;
}

}  // namespace placode::sim

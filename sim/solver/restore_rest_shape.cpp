// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// States that a method does not leave by itself. Tissue shrunk to a point: F = 0 there, so that the
// gradients of |F|^2 and of J are both zero. And a free piece at rest in a fold, another minimum of
// the energy: without load, what is at rest and not stressed by anybody must have its rest shape.

#include "sim/solver/restore_rest_shape.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/double_float.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

constexpr double kCollapsed = 1e-3;  // of the rest length; a working solver never comes near
constexpr uint8_t kSeen = 2;         // in free_vertex, for the time of the search
constexpr double kFolded = 0.4;      // edge against rest; pre-tension is at most 0.15
constexpr double kBalanced = 0.05;   // a vertex would go on, of its shortest edge

bool collapsed(const SoftBody& body, const SoftBodyState& state, int tet) noexcept {
    if (state.tet_alive[as_index(tet)] == 0) return false;
    const auto& k = corners(body, state, tet);
    for (size_t i = 1; i < 4; ++i) {
        for (size_t j = 0; j < i; ++j) {
            const double now =
                (to_vec(state.x[as_index(k[i])]) - to_vec(state.x[as_index(k[j])])).norm();
            const double rest =
                (rest_place(body, state, k[i]) - rest_place(body, state, k[j])).norm();
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

Vec3 rest_of(const SoftBody& body, const SoftBodyState& state, size_t v) noexcept {
    return rest_place(body, state, static_cast<int>(v));
}

/// Largest relative difference of an edge around a vertex from its rest length.
double worst_edge(const SoftBody& body, const SoftBodyState& state, size_t v) noexcept {
    double worst = 0;
    for (const int32_t t : tets_around(body, state, static_cast<int>(v))) {
        if (state.tet_alive[as_index(t)] == 0) continue;
        for (const int32_t other : corners(body, state, t)) {
            if (as_index(other) == v) continue;
            const double rest =
                (rest_of(body, state, as_index(other)) - rest_of(body, state, v)).norm();
            const double now = (to_vec(state.x[as_index(other)]) - to_vec(state.x[v])).norm();
            worst = std::max(worst, std::abs(now / rest - 1));
        }
    }
    return worst;
}

/// Lists the piece of free vertices around `first` in scratch, marks it kSeen, returns its size.
size_t gather_free(const SoftBody& body, SoftBodyState& state, int32_t first) noexcept {
    size_t count = 0;
    const auto reach = [&](int32_t v) {
        if (state.free_vertex[as_index(v)] != 1) return;
        state.free_vertex[as_index(v)] |= kSeen;
        state.scratch[count++] = v;
    };
    reach(first);
    for (size_t head = 0; head < count; ++head) {
        for (const int32_t t : tets_around(body, state, state.scratch[head])) {
            if (state.tet_alive[as_index(t)] == 0) continue;
            for (const int32_t v : corners(body, state, t)) reach(v);
        }
        for (const int32_t t : body.packed().sheet.around(state.scratch[head])) {
            for (const int32_t v : body.packed().sheet.triangles[as_index(t)].v) reach(v);
        }
    }
    return count;
}

/// True where a vertex would hardly move if its neighbours stayed where they are. At the turning
/// point of a swing nothing moves either, but the surface is out of balance.
bool balanced(const SoftBody& body, const SoftBodyState& state, int vertex) noexcept {
    constexpr double kNoInertia = 1e3;  // a step of so many seconds
    const VertexSystem s = vertex_system(body, state, vertex, kNoInertia);
    const Vec3 step = s.hessian.ldlt().solve(s.gradient);
    return step.norm() <
           kBalanced *
               static_cast<double>(body.shortest_edge_m()[as_index(origin_of(state, vertex))]);
}

/// True when the piece in scratch is at rest, untouched and folded.
bool rests_folded(const SoftBody& body, const SoftBodyState& state, size_t count,
                  const Vec3& velocity, double slow_m_s) noexcept {
    double worst = 0;
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        if (state.contact_vertex[v] != 0 || state.x[v].w == 0) return false;
        if (!((to_vec(state.v[v]) - velocity).norm() < slow_m_s)) return false;
        worst = std::max(worst, worst_edge(body, state, v));
    }
    if (!(worst > kFolded)) return false;
    return std::all_of(state.scratch.begin(), state.scratch.begin() + static_cast<int64_t>(count),
                       [&](int32_t v) { return balanced(body, state, v); });
}

/// Rest shape in the place and turn that fit the piece in scratch best (Kabsch).
void unfold(const SoftBody& body, SoftBodyState& state, size_t count,
            const Vec3& velocity) noexcept {
    Vec3 middle = Vec3::Zero(), rest_middle = Vec3::Zero();
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        middle += to_vec(state.x[v]) / static_cast<double>(count);
        rest_middle += rest_of(body, state, v) / static_cast<double>(count);
    }
    Mat3 sum = Mat3::Zero();
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        sum += (to_vec(state.x[v]) - middle) * (rest_of(body, state, v) - rest_middle).transpose();
    }
    const Eigen::JacobiSVD<Mat3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 turn = svd.matrixU() * svd.matrixV().transpose();
    if (turn.determinant() < 0) {
        Mat3 u = svd.matrixU();
        u.col(2) = -u.col(2);
        turn = u * svd.matrixV().transpose();
    }
    const Vec3f u = velocity.cast<float>();
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        put_vertex(state, state.scratch[i],
                   middle + turn * (rest_of(body, state, v) - rest_middle));
        state.v[v] = {u.x(), u.y(), u.z(), 0};
    }
}

int restore_folded(const SoftBody& body, SoftBodyState& state, double slow_m_s) noexcept {
    int placed = 0;
    for (size_t first = 0; first < state.free_vertex.size(); ++first) {
        if (state.free_vertex[first] != 1) continue;
        const size_t count = gather_free(body, state, static_cast<int32_t>(first));
        Vec3 velocity = Vec3::Zero();
        for (size_t i = 0; i < count; ++i) {
            velocity += to_vec(state.v[as_index(state.scratch[i])]) / static_cast<double>(count);
        }
        if (!rests_folded(body, state, count, velocity, slow_m_s)) continue;
        unfold(body, state, count, velocity);
        placed += static_cast<int>(count);
    }
    for (uint8_t& f : state.free_vertex) f &= static_cast<uint8_t>(~kSeen);
    return placed;
}

/// The same of a triangle of the sheet.
bool collapsed(const SoftBody& body, const SoftBodyState& state, const SheetElement& t) noexcept {
    for (size_t k = 0; k < 3; ++k) {
        const size_t a = as_index(t.v[k]), b = as_index(t.v[(k + 1) % 3]);
        const double now = (to_vec(state.x[a]) - to_vec(state.x[b])).norm();
        if (!(now < kCollapsed * (body.mesh().rest[a] - body.mesh().rest[b]).norm())) return false;
    }
    return true;
}

/// Lists the collapsed piece around `seeds` in scratch and returns its size.
size_t gather_collapsed(const SoftBody& body, SoftBodyState& state,
                        std::span<const int32_t> seeds) noexcept {
    size_t count = 0;
    const auto reach = [&](int32_t v) {
        if ((state.free_vertex[as_index(v)] & kSeen) != 0) return;
        state.free_vertex[as_index(v)] |= kSeen;
        state.scratch[count++] = v;
    };
    const SheetElements& sheet = body.packed().sheet;
    for (const int32_t v : seeds) reach(v);
    for (size_t head = 0; head < count; ++head) {
        for (const int32_t other : tets_around(body, state, state.scratch[head])) {
            if (!collapsed(body, state, other)) continue;
            for (const int32_t v : corners(body, state, other)) reach(v);
        }
        for (const int32_t other : sheet.around(state.scratch[head])) {
            if (!collapsed(body, state, sheet.triangles[as_index(other)])) continue;
            for (const int32_t v : sheet.triangles[as_index(other)].v) reach(v);
        }
    }
    for (size_t i = 0; i < count; ++i) {
        state.free_vertex[as_index(state.scratch[i])] &= static_cast<uint8_t>(~kSeen);
    }
    return count;
}

/// Rest shape for the piece in scratch. Returns the number of vertices that were moved.
int place_at_rest(const SoftBody& body, SoftBodyState& state, size_t count) noexcept {
    Piece piece;
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        piece.add(rest_of(body, state, v), state.x[v], state.v[v]);
    }
    const Vec3 offset =
        piece.held > 0 ? Vec3(piece.held_moved / piece.held) : Vec3(piece.moved / piece.vertices);
    const Vec3f u = (piece.velocity / piece.vertices).cast<float>();
    int placed = 0;
    for (size_t i = 0; i < count; ++i) {
        const size_t v = as_index(state.scratch[i]);
        if (state.x[v].w == 0) continue;
        put_vertex(state, state.scratch[i], rest_of(body, state, v) + offset);
        state.v[v] = {u.x(), u.y(), u.z(), 0};
        ++placed;
    }
    return placed;
}

}  // namespace

int restore_collapsed(const SoftBody& body, SoftBodyState& state, double slow_m_s) noexcept {
    int placed = restore_folded(body, state, slow_m_s);
    for (int t = 0; t < body.tet_count(); ++t) {
        if (!collapsed(body, state, t)) continue;
        const size_t count = gather_collapsed(body, state, corners(body, state, t));
        placed += place_at_rest(body, state, count);
    }
    for (const SheetElement& t : body.packed().sheet.triangles) {
        if (!collapsed(body, state, t)) continue;
        placed += place_at_rest(body, state, gather_collapsed(body, state, t.v));
    }
    if (placed > 0) {
        state.flags |= kRestShapeRestored;
        rouse_all(state);
    }
    return placed;
}

}  // namespace placode::sim

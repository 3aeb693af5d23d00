// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/slide_choice.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/surface.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

constexpr double kOnPlane = 2e-6;    // nearer to the plane than that needs no slide [m]
constexpr double kCreaseCos = 0.75;  // faces that differ more meet at a crease
constexpr uint32_t kPlacodeBit = 1U << static_cast<int>(Tissue::kPlacode);

bool has(const std::array<int32_t, 4>& c, int32_t v) noexcept {
    return std::find(c.begin(), c.end(), v) != c.end();
}

uint32_t tissue_bit(const Scene& scene, int32_t tet) noexcept {
    return 1U << static_cast<int>(scene.body.mesh().tissue[tet]);
}

Vec3 face_normal(const SoftBodyState& body, const std::array<int32_t, 4>& c, int f) noexcept {
    const Vec3 a = position(body, c[kTetFaces[f][0]]);
    const Vec3 b = position(body, c[kTetFaces[f][1]]);
    return (b - a).cross(position(body, c[kTetFaces[f][2]]) - a).normalized();
}

}  // namespace

void SlideChooser::Surroundings::add_face(const Vec3& n) noexcept {
    if (faces++ == 0) normal = n;
    least_cos = std::min(least_cos, n.dot(normal));
}

bool SlideChooser::Surroundings::crease() const noexcept { return least_cos < kCreaseCos; }

bool SlideChooser::in_reach(const Vec3& p) const noexcept {
    // A face whose centre the blades meet has corners beyond their ends and edges.
    const double pad = reach_.pad_m;
    return p.z() <= pad && p.z() >= -reach_.length_m - pad &&
           std::abs(p.y()) <= reach_.slope * std::max(0.0, reach_.length_m + p.z()) + pad;
}

bool SlideChooser::crossed(int32_t vertex) const noexcept {
    const Vec3 at = place(vertex);
    if (std::abs(at.x()) < kOnPlane) return false;
    for (const int32_t t : tets_around(scene_.body, state_.body, vertex)) {
        if (state_.body.tet_alive[t] == 0) continue;
        for (const int32_t other : corners(scene_.body, state_.body, t)) {
            if (other == vertex) continue;
            const Vec3 p = place(other);
            if (std::abs(p.x()) < kOnPlane || p.x() * at.x() > 0) continue;
            if (in_reach(at + at.x() / (at.x() - p.x()) * (p - at))) return true;
        }
    }
    return false;
}

SlideChoice SlideChooser::choose(int32_t vertex) const noexcept {
    Search search;
    search.vertex = search.best.slide.vertex = vertex;
    search.at = place(vertex);
    search.here = look_around(vertex, -1);
    try_all(search);
    // Where tissues meet, their border bends a little before the cut does; not the placode's.
    search.strict = (search.here.tissues & kPlacodeBit) != 0 || search.here.crease();
    if (search.best.shift_m < 0 && !search.strict) try_all(search);
    return search.best;
}

SlideChooser::Surroundings SlideChooser::look_around(int32_t vertex, int32_t other) const noexcept {
    Surroundings out;
    for (const int32_t t : tets_around(scene_.body, state_.body, vertex)) {
        if (state_.body.tet_alive[t] == 0) continue;
        const auto& c = corners(scene_.body, state_.body, t);
        if (other >= 0 && !has(c, other)) continue;
        out.tissues |= tissue_bit(scene_, t);
        for (int f = 0; f < 4; ++f) {
            if (c[f] != vertex && c[f] != other && state_.surface.on_surface(t, f))
                out.add_face(face_normal(state_.body, c, f));
        }
    }
    return out;
}

bool SlideChooser::may_follow_edge(const Search& search, int32_t other) const noexcept {
    const Surroundings edge = look_around(search.vertex, other);
    if (edge.tissues != search.here.tissues) return false;
    return search.here.faces == 0 || (edge.faces == 2 && (!search.here.crease() || edge.crease()));
}

bool SlideChooser::may_enter_face(const Search& search, int32_t tet, int f) const noexcept {
    if (search.here.crease()) return false;
    const bool surface = state_.surface.on_surface(tet, f);
    if (surface != (search.here.faces > 0)) return false;
    uint32_t tissues = tissue_bit(scene_, tet);
    if (!surface) tissues |= tissue_bit(scene_, scene_.surface.neighbours()[tet][f]);
    return search.strict ? tissues == search.here.tissues : (tissues & ~search.here.tissues) == 0;
}

void SlideChooser::try_all(Search& search) const noexcept {
    for (const int32_t t : tets_around(scene_.body, state_.body, search.vertex)) {
        if (state_.body.tet_alive[t] != 0) try_tet(search, t);
    }
}

void SlideChooser::try_tet(Search& search, int32_t tet) const noexcept {
    const auto& c = corners(scene_.body, state_.body, tet);
    std::array<int32_t, 3> others{};
    size_t n = 0;
    for (const int32_t v : c) {
        if (v != search.vertex) others[n++] = v;
    }
    // Edges and faces bound what a tet offers: nothing shorter lies in them alone.
    if (search.here.faces == 0 && search.here.tissues == tissue_bit(scene_, tet))
        try_simplex<3>(search, others);
    for (int f = 0; f < 4; ++f) {
        if (c[f] == search.vertex || !may_enter_face(search, tet, f)) continue;
        std::array<int32_t, 3> pair{-1, -1, -1};
        n = 0;
        for (const int32_t v : others) {
            if (v != c[f]) pair[n++] = v;
        }
        try_simplex<2>(search, pair);
    }
    for (const int32_t v : others) try_simplex<1>(search, {v, -1, -1});
}

/// Least |E w|, E the edges at rest, with at + sum w (x - at) on the plane and w in the simplex.
template <int N>
void SlideChooser::try_simplex(Search& search,
                               const std::array<int32_t, 3>& towards) const noexcept {
    Eigen::Matrix<double, 3, N> rest;
    Eigen::Matrix<double, N, 1> across;
    const Vec3& from = rest_place(scene_.body, state_.body, search.vertex);
    for (int i = 0; i < N; ++i) {
        const int32_t v = towards[static_cast<size_t>(i)];
        rest.col(i) = rest_place(scene_.body, state_.body, v) - from;
        across[i] = place(v).x() - search.at.x();
    }
    const Eigen::Matrix<double, N, N> metric = rest.transpose() * rest;
    const Eigen::Matrix<double, N, 1> steepest = metric.inverse() * across;
    const double slope = across.dot(steepest);
    if (!(slope > 0)) return;
    const Eigen::Matrix<double, N, 1> w = -search.at.x() / slope * steepest;
    if (!(w.minCoeff() >= 0 && w.sum() <= scene_.cut_snap)) return;
    const auto length = static_cast<float>((rest * w).norm());
    if (search.best.shift_m >= 0 && length >= search.best.shift_m) return;
    if (N == 1 && !may_follow_edge(search, towards[0])) return;
    Slide slide{search.vertex, towards, {}};
    for (int i = 0; i < N; ++i) slide.share[static_cast<size_t>(i)] = static_cast<float>(w[i]);
    if (!slide_fits(scene_.body, state_.body, state_.body.topology->rest, slide, SlideLimits{}))
        return;
    search.best = {slide, length};
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/self_contact.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/contact_core.h"
#include "sim/contact/surface_face.h"
#include "sim/core/tool_shape.h"
#include "sim/mesh/box_distance.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kMostPairs = 1024;         // of a group
constexpr double kMovedM = 0.001;        // this far from its place at rest, tissue can meet other
constexpr double kApartAtRest = 0.0015;  // faces nearer than this at rest are its own surroundings
constexpr double kReachM = 0.0008;  // at 0.1 m/s tissue moves 0.4 mm until it is looked up again
constexpr double kDeepestM = 4e-4;  // deeper in, a vertex belongs to the other side
constexpr double kBesideM = 1e-4;   // so far beside a face a vertex still touches it
constexpr double kStaleM = 1e-4;    // boxes may be those of the frame before
constexpr int64_t kBesideFrames = 12;

Vec3 rest_of(const Scene& scene, const State& state, int32_t v) noexcept {
    return scene.body.mesh().rest[static_cast<size_t>(origin_of(state.body, v))];
}

/// A tet behind the surface at this vertex; -1 inside of the tissue.
int32_t surface_tet(const Scene& scene, const State& state, int32_t v) noexcept {
    for (const int32_t t : tets_around(scene.body, state.body, v)) {
        if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
        const auto& c = corners(scene.body, state.body, t);
        for (int f = 0; f < 4; ++f) {
            if (c[static_cast<size_t>(f)] != v && state.surface.on_surface(t, f)) return t;
        }
    }
    return -1;
}

/// The nearest face of other tissue within reach; vertex -1 when there is none.
class NearestFace {
 public:
    NearestFace(const Scene& scene, State& state, int32_t v, int32_t tet) noexcept
        : scene_(scene),
          state_(state),
          vertex_(v),
          piece_(state.pieces.of[static_cast<size_t>(tet)]),
          side_(scene.slit.side_of(v)),
          at_(position(state.body, v)),
          rest_(rest_of(scene, state, v)) {}

    TissuePair find() noexcept {
        state_.surface.tree().walk(
            [&](const SurfaceTree::Box& box) noexcept {
                return squared_distance(box, at_, kStaleM) >= best2_;
            },
            [&](int slot) noexcept {
                look_at(state_.surface.triangles()[static_cast<size_t>(slot)]);
            });
        return found_;
    }

 private:
    void look_at(const SurfaceTriangle& face) noexcept {
        Triangle x;
        bool moves = state_.body.x[static_cast<size_t>(vertex_)].w != 0;
        for (int k = 0; k < 3; ++k) {
            const int32_t v = face.vertex[static_cast<size_t>(k)];
            if (v == vertex_) return;
            x[static_cast<size_t>(k)] = position(state_.body, v);
            moves = moves || state_.body.x[static_cast<size_t>(v)].w != 0;
        }
        // What costs least is asked first: most faces are farther off than the best so far.
        if (!moves || beyond_best(x) || own_surroundings(face.vertex, face.tet)) return;
        const double d2 = squared_distance_to(x);
        if (!(d2 < best2_)) return;
        best2_ = d2;
        found_ = {vertex_, face.tet,
                  local_face(corners(scene_.body, state_.body, face.tet), face.vertex)};
        for (const int32_t v : face.vertex) {
            state_.self_contact.near_moved_until[static_cast<size_t>(v)] =
                state_.frame + kBesideFrames;
        }
    }

    [[nodiscard]] double squared_distance_to(const Triangle& x) const noexcept {
        const Vec3 w = closest_on_triangle(at_, x);
        return (at_ - w.x() * x[0] - w.y() * x[1] - w.z() * x[2]).squaredNorm();
    }

    /// By the box around a triangle.
    [[nodiscard]] bool beyond_best(const Triangle& x) const noexcept {
        const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]),
                   high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
        return (low - at_).cwiseMax(at_ - high).cwiseMax(0.0).squaredNorm() >= best2_;
    }

    /// A face of the same piece that was near at rest; the walls of a slit are other tissue to each
    /// other.
    [[nodiscard]] bool own_surroundings(const std::array<int32_t, 3>& face,
                                        int32_t tet) const noexcept {
        if (state_.pieces.of[static_cast<size_t>(tet)] != piece_) return false;
        if (side_ != 0) {
            int own_side = 0, other_side = 0;  // corners on either wall
            for (const int32_t v : face) {
                const int along = side_ * scene_.slit.side_of(v);
                own_side += along > 0 ? 1 : 0;
                other_side += along < 0 ? 1 : 0;
            }
            if (other_side > 0 && own_side == 0) return false;
        }
        Vec3 three_centres = Vec3::Zero();
        for (const int32_t v : face) three_centres += rest_of(scene_, state_, v);
        constexpr double kThreeApart = 3 * kApartAtRest;
        return (three_centres - 3 * rest_).squaredNorm() < kThreeApart * kThreeApart;
    }

    const Scene& scene_;
    State& state_;
    int32_t vertex_;
    int8_t piece_;
    int side_;
    Vec3 at_, rest_;
    double best2_ = kReachM * kReachM;
    TissuePair found_;
};

/// The contact of a pair, by the places at the substep's start. False where they do not touch.
bool touches(const Scene& scene, const State& state, const TissuePair& pair,
             Contact& out) noexcept {
    const auto start = [&](int32_t v) {
        return to_vec(state.body.x_start[static_cast<size_t>(v)]);
    };
    const std::array<int32_t, 3> face = corners_of_face(scene, state, pair.tet, pair.face);
    Triangle x;
    for (size_t k = 0; k < 3; ++k) {
        out.vertex[k + 1] = face[k];
        x[k] = start(face[k]);
    }
    const Vec3 at = start(pair.vertex), w = closest_on_triangle(at, x);
    const Vec3 offset = at - w.x() * x[0] - w.y() * x[1] - w.z() * x[2];
    out.n = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    const double gap = out.n.dot(offset) - kTissueGapM;
    const double aside = (offset - out.n * out.n.dot(offset)).norm();
    if (!(gap < kTissueGapM) || gap < -kDeepestM || !(aside < kBesideM)) return false;
    out.vertex[0] = pair.vertex;
    out.b = {1, -w.x(), -w.y(), -w.z()};
    out.corners = 4;
    out.side = kTissueSide;
    out.stiffness_n_m = 1;
    out.offset_m = -kTissueGapM;
    out.tissue = scene.body.mesh().tissue[static_cast<size_t>(pair.tet)];
    return true;
}

}  // namespace

SelfContact::SelfContact(const Scene& scene) {
    if (!scene.contact.self_contact) return;
    for (auto& group : pairs) group.resize(kMostPairs);
    near_moved_until.assign(static_cast<size_t>(scene.body.vertex_capacity()), -1);
}

void collect_tissue_pairs(const Scene& scene, State& state) noexcept {
    SelfContact& self = state.self_contact;
    if (!self.enabled()) return;
    const auto group = static_cast<size_t>(state.frame % SelfContact::kGroups);
    int32_t& count = self.count[group];
    count = 0;
    const int32_t vertices =
        state.body.topology ? state.body.topology->vertices : scene.body.vertex_count();
    for (auto v = static_cast<int32_t>(group); v < vertices; v += SelfContact::kGroups) {
        const bool near_moved = self.near_moved_until[static_cast<size_t>(v)] >= state.frame;
        if (!near_moved && scene.slit.side_of(v) == 0 &&
            (position(state.body, v) - rest_of(scene, state, v)).squaredNorm() < kMovedM * kMovedM)
            continue;
        const int32_t tet = surface_tet(scene, state, v);
        if (tet < 0) continue;
        const TissuePair pair = NearestFace(scene, state, v, tet).find();
        if (pair.vertex < 0) continue;
        if (count == kMostPairs) {
            state.flags |= kContactsDropped;
            return;
        }
        self.pairs[group][static_cast<size_t>(count++)] = pair;
    }
}

bool touch_tissue(const Scene& scene, State& state) noexcept {
    SelfContact& self = state.self_contact;
    for (size_t group = 0; group < self.pairs.size(); ++group) {
        for (int32_t i = 0; i < self.count[group]; ++i) {
            const TissuePair& pair = self.pairs[group][static_cast<size_t>(i)];
            if (!is_on_surface(state, pair.tet, pair.face)) continue;
            Contact contact;
            if (touches(scene, state, pair, contact) &&
                !add_to_colour(state.scratch->contacts, state.body, contact))
                return false;
        }
    }
    return true;
}

}  // namespace placode::sim

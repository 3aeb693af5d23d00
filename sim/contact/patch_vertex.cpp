// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_vertex.h"

#include <algorithm>

#include "sim/contact/surface_face.h"
#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

constexpr double kPatchDeepest = 8e-4;  // deeper in the tissue, a vertex is let go [m]
constexpr double kPatchBeside = 2e-4;   // below a face, so far beside it a vertex still touches [m]
// Pressure for every metre of overlap. The tissue's load comes a substep late, so it must be below
// what its surface answers at once, rho L / h^2 + E / L: 1.7e7 Pa/m for gel of 3 kPa and L = 0.9
// mm. There 2e7 trembles and 5e6 is quiet.
constexpr double kPressPaM = 5e6;
constexpr double kPressSubstep = 2.5e-4;  // in longer ones as much softer as inertia is [s]
constexpr double kRubShare = 0.5;         // of the friction spring, of the normal one

/// Where the corners of a face will be at the end of a substep, if nothing changes their velocity.
Triangle face_ahead(const State& state, const std::array<int32_t, 3>& face, double h) noexcept {
    Triangle x;
    for (size_t k = 0; k < 3; ++k) {
        const auto v = as_index(face[k]);
        x[k] = to_vec(state.body.x_start[v]);
        if (state.body.x[v].w != 0) x[k] += h * to_vec(state.body.v[v]);
    }
    return x;
}

Vec3 point_on(const Triangle& x, const std::array<float, 3>& weight) noexcept {
    Vec3 p = Vec3::Zero();
    for (size_t k = 0; k < 3; ++k) p += static_cast<double>(weight[k]) * x[k];
    return p;
}

std::array<float, 3> weights_at(const Vec3& p, const Triangle& x) noexcept {
    const Vec3f w = closest_on_triangle(p, x).cast<float>();
    return {w.x(), w.y(), w.z()};
}

}  // namespace

PatchVertex::PatchVertex(const Scene& scene, State& state, int32_t number, double h) noexcept
    : scene_(scene),
      patch_(*scene.patch),
      state_(state),
      touch_(state.patch.touch[as_index(number)]),
      vertex_(patch_.first_vertex + number),
      h_(h) {
    const double long_step = std::max(1.0, h / kPressSubstep);
    press_n_m_ =
        kPressPaM * static_cast<double>(patch_.area_m2[as_index(number)]) / (long_step * long_step);
    meet();
}

void PatchVertex::press() noexcept {
    const Vec3 guess = coasting();
    const double load = touches_ ? load_of(guess) : 0;
    if (!(load > 0)) {
        if (touch_.presses != 0) set_spring(scene_.body, state_.body, vertex_, {}, Vec3f::Zero());
        touch_.presses = 0;
        touch_.anchor = {};
        return;
    }
    touch_.presses = 1;
    const Vec3 anchor = anchor_at(guess);
    const Vec3 slide = across(guess - anchor);
    // Beyond Coulomb's limit the secant of the law.
    const double whole = kRubShare * press_n_m_, most = patch_.friction * load;
    const double rub = whole * slide.norm() > most ? most / slide.norm() : whole;
    const Mat3 along = n_ * n_.transpose();
    const Mat3 k = press_n_m_ * along + rub * (Mat3::Identity() - along);
    const Vec3 place = n_ * overlap_at_ + across(anchor);
    const auto f = [&k](int i, int j) { return static_cast<float>(k(i, j)); };
    set_spring(scene_.body, state_.body, vertex_,
               {f(0, 0), f(0, 1), f(0, 2), f(1, 1), f(1, 2), f(2, 2)}, place.cast<float>());
}

void PatchVertex::bear(PatchLoad& out) noexcept {
    out.face[0] = -1;
    const Vec3 x = position(state_.body, vertex_);
    const double load = touches_ ? load_of(x) : 0;
    if (!(load > 0)) return;
    const Vec3 anchor = anchor_at(x), slide = across(x - anchor);
    const double stiffness = kRubShare * press_n_m_;
    const double most = patch_.friction * load, held = stiffness * slide.norm();
    Vec3 rub = stiffness * slide;
    if (held > most) {
        rub *= most / held;
        touch_.anchor = {touch_.tet, touch_.face, weights_at(x - rub / stiffness, ahead_)};
    }
    const Vec3 force = rub - load * n_;
    if (!force.allFinite()) return;
    out.face = face_;
    for (int k = 0; k < 3; ++k) out.force_n[as_index(k)] = weight_[k] * force;
}

/// Where it gets by its velocity alone. Not by its weight: what others hold up a little above
/// the tissue would count as touching, and the tie would pull it down.
Vec3 PatchVertex::coasting() const noexcept {
    const auto v = as_index(vertex_);
    const Vec3 start = to_vec(state_.body.x_start[v]);
    return state_.body.x[v].w == 0 ? start : Vec3(start + h_ * to_vec(state_.body.v[v]));
}

/// By the places at the substep's start.
void PatchVertex::meet() noexcept {
    if (touch_.tet < 0 || !is_on_surface(state_, touch_.tet, touch_.face)) return;
    face_ = corners_of_face(scene_, state_, touch_.tet, touch_.face);
    Triangle start;
    for (size_t k = 0; k < 3; ++k) start[k] = to_vec(state_.body.x_start[as_index(face_[k])]);
    ahead_ = face_ahead(state_, face_, h_);
    const Vec3 x = to_vec(state_.body.x_start[as_index(vertex_)]);
    const Vec3 w = weight_ = closest_on_triangle(x, start);
    const Vec3 way = x - w.x() * start[0] - w.y() * start[1] - w.z() * start[2];
    const Vec3 face = (start[1] - start[0]).cross(start[2] - start[0]).normalized();
    const double height = face.dot(way), distance = way.norm();
    // Outside, the way to the nearest point is a normal that turns smoothly over edges.
    const bool outside = height > 0 && distance > 1e-6;
    n_ = outside ? Vec3(way / distance) : face;
    if (!outside && (height < -kPatchDeepest || (way - height * face).norm() > kPatchBeside))
        return;
    const Vec3 at = w.x() * ahead_[0] + w.y() * ahead_[1] + w.z() * ahead_[2];
    overlap_at_ = n_.dot(at) + patch_.thickness_m / 2;
    touches_ = n_.allFinite();
}

/// Where friction holds the vertex; where it touches first, if nothing does yet.
Vec3 PatchVertex::anchor_at(const Vec3& x) noexcept {
    TissueSpot& anchor = touch_.anchor;
    if (anchor.tet < 0 || !is_on_surface(state_, anchor.tet, anchor.face))
        anchor = {touch_.tet, touch_.face, weights_at(x, ahead_)};
    return point_on(
        face_ahead(state_, corners_of_face(scene_, state_, anchor.tet, anchor.face), h_),
        anchor.weight);
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_vertex.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/patch_fold.h"
#include "sim/contact/surface_face.h"

namespace placode::sim {
namespace {

constexpr double kPatchDeepest = 8e-4;   // deeper in the tissue, a vertex is drawn out [m]
constexpr double kPatchRecovery = 2e-4;  // as gently as from so deep [m]
constexpr double kPatchBeside = 2e-4;  // below a face, so far beside it a vertex still touches [m]
// Pressure for every metre of overlap. The tissue's load comes a substep late, so it must be below
// what its surface answers at once, rho L / h^2 + E / L: 1.7e7 Pa/m for gel of 3 kPa and L = 0.9
// mm. There 2e7 trembles and 5e6 is quiet.
constexpr double kPressPaM = 5e6;
constexpr double kPressSubstep = 2.5e-4;  // in longer ones as much softer as inertia is [s]
constexpr double kRubShare = 0.5;         // of the friction spring, of the normal one
constexpr double kSurelyOutside = 1e-8;   // squared sine of the way to the face's plane
constexpr double kSurelyAwayM = 1e-7;     // more than all rounding
constexpr double kLeastHold = 1e-9;       // of a spring's trace, where it holds nothing

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
      tie_(state.scratch->patch.ties[as_index(number)]),
      number_(number),
      vertex_(patch_.first_vertex + number),
      h_(h) {}

void PatchVertex::press() noexcept {
    meet();
    hold();
    PatchSpring sum;
    const bool meets = state_.scratch->patch.folded &&
                       add_patch_folds(scene_, state_, number_, press_pa_m(), h_, sum);
    if (tie_.holds && !meets) {
        tie(tie_.k_n_m, tie_.place);
    } else if (meets) {
        if (tie_.holds) {
            sum.k_n_m += tie_.k_n_m;
            sum.k_place_n += tie_.k_n_m * tie_.place;
        }
        // Where nothing holds it, across a contact without friction, it stays where it gets.
        const double least = kLeastHold * sum.k_n_m.trace();
        const Mat3 k = sum.k_n_m + least * Mat3::Identity();
        tie(sum.k_n_m, k.inverse() * (sum.k_place_n + least * coasting()));
    } else if (touch_.presses != 0) {
        tie(Mat3::Zero(), Vec3::Zero());
    }
    touch_.presses = tie_.holds || meets ? 1 : 0;
}

void PatchVertex::tie(const Mat3& k, const Vec3& place) noexcept {
    const auto f = [&k](int i, int j) { return static_cast<float>(k(i, j)); };
    set_spring(scene_.body, state_.body, vertex_,
               {f(0, 0), f(0, 1), f(0, 2), f(1, 1), f(1, 2), f(2, 2)}, place.cast<float>());
}

double PatchVertex::press_pa_m() const noexcept {
    const double long_step = std::max(1.0, h_ / kPressSubstep);
    return kPressPaM / (long_step * long_step);
}

/// Ties it to the face while it presses on it.
void PatchVertex::hold() noexcept {
    const Vec3 guess = coasting();
    const double load = tie_.touches ? load_of(guess) : 0;
    tie_.holds = load > 0;
    if (!tie_.holds) {
        touch_.anchor = {};
        return;
    }
    tie_.anchor = find_anchor(guess);
    const Vec3 slide = across(guess - tie_.anchor);
    // Beyond Coulomb's limit the secant of the law.
    const double whole = kRubShare * tie_.press_n_m, most = patch_.friction * load;
    const double rub = whole * slide.norm() > most ? most / slide.norm() : whole;
    const Mat3 along = tie_.n * tie_.n.transpose();
    tie_.k_n_m = tie_.press_n_m * along + rub * (Mat3::Identity() - along);
    tie_.place = tie_.n * tie_.overlap_at_m + across(tie_.anchor);
}

void PatchVertex::bear() noexcept {
    tie_.load_n.setZero();
    if (!tie_.holds) return;
    const Vec3 x = position(state_.body, vertex_);
    const double load = load_of(x);
    if (!(load > 0)) return;
    const Vec3 slide = across(x - tie_.anchor);
    const double stiffness = kRubShare * tie_.press_n_m;
    const double most = patch_.friction * load, held = stiffness * slide.norm();
    Vec3 rub = stiffness * slide;
    if (held > most) {
        rub *= most / held;
        touch_.anchor = {touch_.tet, touch_.face, weights_at(x - rub / stiffness, tie_.ahead)};
    }
    const Vec3 force = rub - load * tie_.n;
    if (force.allFinite()) tie_.load_n = force;
}

/// Where it gets by its velocity alone. Not by its weight: what others hold up a little above
/// the tissue would count as touching, and the tie would pull it down.
Vec3 PatchVertex::coasting() const noexcept {
    const auto v = as_index(vertex_);
    const Vec3 start = to_vec(state_.body.x_start[v]);
    return state_.body.x[v].w == 0 ? start : Vec3(start + h_ * to_vec(state_.body.v[v]));
}

/// Most of what is near the tissue does not come to touch it in a substep, whatever the velocities
/// there are; that is cheaper to say than where it would touch.
/// @param way from the face's nearest point. @param turned the face's normal, of any length.
bool PatchVertex::stays_away(const Vec3& offset, const Vec3& turned) const noexcept {
    const double height = turned.dot(offset), distance2 = offset.squaredNorm();
    // Beside the face or behind it: not here.
    if (!(height > 0) || !(height * height > kSurelyOutside * turned.squaredNorm() * distance2))
        return false;
    const auto speed = [&](int32_t v) {
        const Float4& s = state_.body.v[as_index(v)];
        return static_cast<double>(std::abs(s.x) + std::abs(s.y) + std::abs(s.z));
    };
    const double face = std::max({speed(tie_.face[0]), speed(tie_.face[1]), speed(tie_.face[2])});
    const double reach =
        patch_.thickness_m / 2 + kSurelyAwayM + 1.001 * h_ * (speed(vertex_) + face);
    return distance2 > reach * reach;
}

/// By the places at the substep's start.
void PatchVertex::meet() noexcept {
    tie_.touches = false;
    if (touch_.tet < 0 || !is_on_surface(state_, touch_.tet, touch_.face)) return;
    tie_.face = corners_of_face(scene_, state_, touch_.tet, touch_.face);
    Triangle start;
    for (size_t k = 0; k < 3; ++k) start[k] = to_vec(state_.body.x_start[as_index(tie_.face[k])]);
    const Vec3 x = to_vec(state_.body.x_start[as_index(vertex_)]);
    const Vec3 w = tie_.weight = closest_on_triangle(x, start);
    const Vec3 offset = x - w.x() * start[0] - w.y() * start[1] - w.z() * start[2];
    const Vec3 turned = (start[1] - start[0]).cross(start[2] - start[0]);
    if (stays_away(offset, turned)) return;
    tie_.ahead = face_ahead(state_, tie_.face, h_);
    const Vec3 face = turned.normalized();
    const double height = face.dot(offset), distance = offset.norm();
    // Outside, the way to the nearest point is a normal that turns smoothly over edges.
    const bool outside = height > 0 && distance > 1e-6;
    tie_.n = outside ? Vec3(offset / distance) : face;
    if (!outside && (offset - height * face).norm() > kPatchBeside) return;
    const Vec3 at = w.x() * tie_.ahead[0] + w.y() * tie_.ahead[1] + w.z() * tie_.ahead[2];
    tie_.overlap_at_m = tie_.n.dot(at) + patch_.thickness_m / 2;
    if (height < -kPatchDeepest) tie_.overlap_at_m = tie_.n.dot(x) + kPatchRecovery;
    tie_.press_n_m = press_pa_m() * static_cast<double>(patch_.area_m2[as_index(number_)]);
    tie_.touches = tie_.n.allFinite();
}

/// Where friction holds the vertex; where it touches first, if nothing does yet.
Vec3 PatchVertex::find_anchor(const Vec3& x) noexcept {
    TissueSpot& anchor = touch_.anchor;
    if (anchor.tet < 0 || !is_on_surface(state_, anchor.tet, anchor.face))
        anchor = {touch_.tet, touch_.face, weights_at(x, tie_.ahead)};
    if (anchor.tet == touch_.tet && anchor.face == touch_.face)
        return point_on(tie_.ahead, anchor.weight);
    return point_on(
        face_ahead(state_, corners_of_face(scene_, state_, anchor.tet, anchor.face), h_),
        anchor.weight);
}

}  // namespace placode::sim

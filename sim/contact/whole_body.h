// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a body moves and turns as a whole within a substep, for a patch (patch_modes.h) and for loose
// pieces of tissue (free_pieces.h). To move and turn it as it is costs no elastic energy, so that
// six unknowns settle it: its momentum and angular momentum change by what others and gravity give,
// and by nothing else. One Newton step on them, as the rigid modes of verification scenes
// (sim/verify/rigid_modes.h), without allocation.
//
// All places are from one point near the body, so that nothing is lost where they are subtracted.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/contact/contact_core.h"
#include "sim/core/turn.h"

namespace placode::sim {

/// Forces on a body and how they change as it moves and turns about a point. Times h^2.
struct Pushes {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Mat3 moves = Mat3::Zero(), mixed = Mat3::Zero(), turns = Mat3::Zero();

    /// @param stiffness symmetric, of a force that acts at r.
    void add(const Vec3& r, const Vec3& push, const Mat3& stiffness) noexcept {
        force += push;
        torque += r.cross(push);
        const Mat3 by_turn = stiffness * cross_matrix(r);
        moves += stiffness;
        mixed += by_turn;
        turns += cross_matrix(r).transpose() * by_turn;
    }
    /// The same about a point that lies at c.
    [[nodiscard]] Pushes about(const Vec3& c) const noexcept;
};

/// What the vertices of a body have done in a substep, and what they would have done alone.
struct WholeSums {
    double mass_kg = 0;
    Vec3 place = Vec3::Zero(), start = Vec3::Zero();   ///< sum m r now, and at the start
    Vec3 went = Vec3::Zero(), planned = Vec3::Zero();  ///< sum m of ways, real and without forces
    Vec3 missing_turn = Vec3::Zero();  ///< sum m (r x plan at the start - r x way now)
    Mat3 inertia = Mat3::Zero();       ///< About the origin.

    /// @param r, before places now and at the start. @param wanted way without neighbours [m].
    void add(double m, const Vec3& r, const Vec3& before, const Vec3& wanted) noexcept {
        const Vec3 offset = r - before;
        mass_kg += m;
        place += m * r;
        start += m * before;
        went += m * offset;
        planned += m * wanted;
        missing_turn += m * (before.cross(wanted) - r.cross(offset));
        inertia += inertia_of(m, r);
    }
};

/// A turn about the centre of mass, and an offset.
struct WholeStep {
    Vec3 centre = Vec3::Zero(), offset = Vec3::Zero();  ///< [m]
    Vec3 turn = Vec3::Zero();                           ///< [rad]

    /// Of a turn by Cayley's form: exact, and without the library's sine, whose last bit depends on
    /// the processor. Less one.
    [[nodiscard]] Mat3 change() const noexcept {
        Quat q;
        q.coeffs() << turn / 2, 1;
        return q.normalized().toRotationMatrix() - Mat3::Identity();
    }
};

/// The step after which momentum and angular momentum are what `pushes` give; nothing where there
/// is no such step. @param turns false: an offset alone, of a body that is too thin to be turned.
[[nodiscard]] std::optional<WholeStep> whole_step(const WholeSums& sums, const Pushes& pushes,
                                                  bool turns = true) noexcept;

/// What instruments press on a body at the present places, and friction there.
/// @param from where places are from. @param h2 square of a substep [s^2]. @param owns (vertex)
/// whether it is one of the body's.
template <class Owns>
void add_instruments(const ContactLists& set, const SoftBodyState& body, const Vec3& from,
                     double h2, Owns&& owns, Pushes& pushes) noexcept {
    for (int32_t i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[as_index(i)];
        if (c.side < 0 || !owns(c.vertex[0])) continue;
        const double gap = gap_of(c, body);
        if (gap >= 0) continue;
        Vec3 at = Vec3::Zero();
        for (size_t k = 0; k < as_index(c.corners); ++k)
            at += c.b[k] * (position(body, c.vertex[k]) - from);
        const double k = h2 * c.stiffness_n_m;
        pushes.add(at, -k * gap * c.n, k * c.n * c.n.transpose());
    }
    for (int32_t i = 0; i < set.vertex_count; ++i) {
        const ContactVertex& touched = set.vertices[as_index(i)];
        if (touched.side < 0 || !owns(touched.vertex)) continue;
        const Friction f = friction_of(touched, body);
        if (!(f.stiffness_n_m > 0)) continue;
        const double k = h2 * f.stiffness_n_m;
        pushes.add(position(body, touched.vertex) - from, -k * f.slide,
                   k * (Mat3::Identity() - f.normal * f.normal.transpose()));
    }
}

/// Moves a body of `count` vertices, the i-th of which is vertex_of(i), as it is; so much less of
/// it that none moves farther than `most_m`. What moves less than floats resolve a few centimetres
/// from the origin is at rest: it must not creep by rounding. Returns the longest way [m].
template <class VertexOf>
double move_whole(SoftBodyState& body, const Vec3& from, const WholeStep& step, int32_t count,
                  double most_m, VertexOf&& vertex_of) noexcept {
    constexpr double kRounding = 1e-10;  // [m]
    const Mat3 change = step.change();
    const auto way = [&](int32_t v) noexcept {
        return Vec3(step.offset + change * (position(body, v) - from - step.centre));
    };
    double longest = 0;
    for (int32_t i = 0; i < count; ++i)
        longest = std::max(longest, way(vertex_of(i)).squaredNorm());
    longest = std::sqrt(longest);
    if (longest < kRounding) return 0;
    const double share = longest > most_m ? most_m / longest : 1;
    for (int32_t i = 0; i < count; ++i) {
        const int32_t v = vertex_of(i);
        const Vec3 to = share * way(v);
        Float4& x = body.x[as_index(v)];
        x = {static_cast<float>(static_cast<double>(x.x) + to.x()),
             static_cast<float>(static_cast<double>(x.y) + to.y()),
             static_cast<float>(static_cast<double>(x.z) + to.z()), x.w};
    }
    return share * longest;
}

}  // namespace placode::sim

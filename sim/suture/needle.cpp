// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/needle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/suture/arc_tangent.h"

namespace placode::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kThickest = 0.1;  // of the wire's radius to the circle's
constexpr double kNear = 0.1;      // tangent of what foot_near() covers

/// From sums and products: the last bit of the library's depends on the processor. A quarter of the
/// angle by the series, whose first left-out term is below 1e-19, then twice the double angle.
/// @pre |angle| <= pi
struct SineCosine {
    explicit SineCosine(double angle) noexcept {
        const double a = angle / 4, a2 = a * a;
        sine = cosine = 0;
        for (int k = 19; k >= 1; k -= 2) {
            sine = 1 - a2 / ((k + 1) * (k + 2)) * sine;
            cosine = 1 - a2 / (k * (k + 1)) * cosine;
        }
        sine *= a;
        for (int i = 0; i < 2; ++i) {
            const double twice = 2 * sine * cosine;
            cosine = 1 - 2 * sine * sine;
            sine = twice;
        }
    }
    double sine, cosine;
};

}  // namespace

Needle::Needle(const NeedleSpec& spec) : spec_(spec) {
    need_within("needle.arc_m", spec.arc_m, 5e-3, 40e-3);
    need_within("needle.wire_radius_m", spec.wire_radius_m, 0.05e-3,
                std::min(0.5e-3, kThickest * spec.arc_m / kPi));
    need_within("needle.density_kg_m3", spec.density_kg_m3, 1000, 25000);
    const double r = radius_m_ = spec.arc_m / kPi;
    const double m = mass_kg_ =
        spec.density_kg_m3 * kPi * spec.wire_radius_m * spec.wire_radius_m * spec.arc_m;
    // Half a thin ring: about its centre m R^2 / 2, m R^2 / 2, m R^2.
    const double d = 2 * r / kPi;
    centre_m_ = Vec3(0, d, 0);
    inertia_ = Vec3(m * r * r / 2 - m * d * d, m * r * r / 2, m * r * r - m * d * d);
}

ArcPoint Needle::at(double s_m) const noexcept {
    const SineCosine from_middle(s_m / radius_m_ - kPi / 2);
    const double c = -from_middle.sine, s = from_middle.cosine;
    return {Vec3(radius_m_ * c, radius_m_ * s, 0), Vec3(-s, c, 0), Vec3(c, s, 0)};
}

ArcFoot Needle::across_from(const Vec3& p_N) const noexcept {
    ArcFoot f;
    const double x = p_N.x(), y = p_N.y();
    f.ring_m = std::sqrt(x * x + y * y);
    f.radial_m = f.ring_m - radius_m_;
    f.across_m = p_N.z();
    if (!(f.ring_m > 0)) return f;
    f.radial = Vec3(x / f.ring_m, y / f.ring_m, 0);
    f.back = Vec3(-f.radial.y(), f.radial.x(), 0);
    return f;
}

ArcFoot Needle::foot(const Vec3& p_N) const noexcept {
    ArcFoot f = across_from(p_N);
    if (!(f.ring_m > 0)) return f;
    const double x = p_N.x(), y = p_N.y();
    // From the arc's middle, so that the seam lies opposite to it: the tangent of half the angle,
    // each half of the plane by the form that does not cancel there.
    const double beyond = x != 0 ? -(f.ring_m - y) / x : 1e18;
    const double half = y >= 0 ? -x / (f.ring_m + y) : beyond;
    f.s_m = radius_m_ * (kPi / 2 + 2 * arc_tangent(half));
    return f;
}

ArcFoot Needle::foot_near(const Vec3& p_N, const Vec3& radial, double s_m) const noexcept {
    ArcFoot f = across_from(p_N);
    const double across = radial.x() * f.radial.y() - radial.y() * f.radial.x();
    const double along = radial.x() * f.radial.x() + radial.y() * f.radial.y();
    if (!(along > 0) || std::abs(across) > kNear * along) return foot(p_N);
    const double t = across / along, t2 = t * t;
    // The first term that is left out is below 1e-15 radians.
    f.s_m =
        s_m + radius_m_ * t *
                  (1 - t2 * (1.0 / 3 -
                             t2 * (1.0 / 5 -
                                   t2 * (1.0 / 7 - t2 * (1.0 / 9 - t2 * (1.0 / 11 - t2 / 13))))));
    return f;
}

}  // namespace placode::sim

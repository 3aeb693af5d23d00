// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/core/tool_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace placode::sim {
namespace {

// Length of the shoulder for every metre of radius that it gains: a 56 degree cone.
constexpr double kShoulderSlope = 1.5;

double length2(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

}  // namespace

double segment_segment(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, double& s,
                       double& t) noexcept {
    const Vec3 d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
    const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
    const double scale = std::max(a, e) * 1e-14;
    if (a <= scale && e <= scale) {
        s = t = 0;
    } else if (a <= scale) {
        s = 0;
        t = std::clamp(f / e, 0.0, 1.0);
    } else {
        const double c = d1.dot(r);
        if (e <= scale) {
            t = 0;
            s = std::clamp(-c / a, 0.0, 1.0);
        } else {
            const double b = d1.dot(d2), denominator = a * e - b * b;
            s = denominator > a * e * 1e-12 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0)
                                            : 0.0;
            t = (b * s + f) / e;
            if (t < 0) {
                t = 0;
                s = std::clamp(-c / a, 0.0, 1.0);
            } else if (t > 1) {
                t = 1;
                s = std::clamp((b - c) / a, 0.0, 1.0);
            }
        }
    }
    return (p0 + s * d1 - q0 - t * d2).squaredNorm();
}

namespace {

/// Point of the triangle nearest to the segment of axis from z = -near to z = -far; true in
/// `pierced` when the axis runs through the triangle.
Vec3 nearest_to_axis(const RoundCone& part, const Triangle& tri, bool& pierced) noexcept {
    const Vec3 a(0, 0, -part.near_m), b(0, 0, -part.far_m);
    pierced = false;
    // Through the triangle? The axis is x = y = 0, so the weights are areas in the xy plane.
    const auto cross2 = [](const Vec3& u, const Vec3& v) { return u.x() * v.y() - u.y() * v.x(); };
    Vec3 w(cross2(tri[1], tri[2]), cross2(tri[2], tri[0]), cross2(tri[0], tri[1]));
    const double area = w.sum();
    if ((w.array() >= 0).all() || (w.array() <= 0).all()) {
        const double size2 = (tri[1] - tri[0]).squaredNorm() + (tri[2] - tri[0]).squaredNorm();
        if (std::abs(area) > 1e-9 * size2) {
            w /= area;
            const double z = w.x() * tri[0].z() + w.y() * tri[1].z() + w.z() * tri[2].z();
            if (z <= a.z() && z >= b.z()) {
                pierced = true;
                return w;
            }
        }
    }
    Vec3 best = closest_on_triangle(a, tri);
    const auto at = [&](const Vec3& weight) -> Vec3 {
        return weight.x() * tri[0] + weight.y() * tri[1] + weight.z() * tri[2];
    };
    double best2 = (at(best) - a).squaredNorm();
    const Vec3 other = closest_on_triangle(b, tri);
    const double other2 = (at(other) - b).squaredNorm();
    if (other2 < best2) {
        best = other;
        best2 = other2;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        double s = 0, t = 0;
        const double d2 = segment_segment(a, b, tri[i], tri[j], s, t);
        if (d2 < best2) {
            best2 = d2;
            best.setZero();
            best[i] = 1 - t;
            best[j] = t;
        }
    }
    return best;
}

/// Distance behind the tip of the sphere centre that a point of the part's surroundings sees.
double foot_of(const RoundCone& part, const Vec3& p, const Vec3& gradient) noexcept {
    const double rho = length2(p.x(), p.y());
    const double along = length2(gradient.x(), gradient.y());
    if (along < 1e-9) return -p.z() < part.near_m ? part.near_m : part.far_m;
    return std::clamp(-p.z() + gradient.z() * rho / along, part.near_m, part.far_m);
}

}  // namespace

namespace {

/// A place or direction of T as one of the jaws sees it that was turned to `side` (1 = towards +y),
/// and back.
class Jaw {
 public:
    Jaw(const ToolShape& shape, double side) noexcept
        : sine_(side * static_cast<double>(shape.spread_sine)),
          cosine_(std::sqrt(1 - sine_ * sine_)),
          hinge_m_(shape.parts[0].far_m) {}
    [[nodiscard]] Vec3 seen(const Vec3& p_T) const noexcept {
        const double z = p_T.z() + hinge_m_;
        return {p_T.x(), cosine_ * p_T.y() - sine_ * z, sine_ * p_T.y() + cosine_ * z - hinge_m_};
    }
    [[nodiscard]] Vec3 back(const Vec3& n) const noexcept {
        return {n.x(), cosine_ * n.y() + sine_ * n.z(), cosine_ * n.z() - sine_ * n.y()};
    }

 private:
    double sine_, cosine_, hinge_m_;
};

}  // namespace

void ToolShape::spread_jaws(double jaw_rad) noexcept {
    // By the series: the library's last bit depends on the processor. At 0.5 rad right to 2e-6.
    const double half = std::clamp(jaw_rad / 2, 0.0, 1.0), square = half * half;
    spread_sine = static_cast<float>(half * (1 - square / 6 * (1 - square / 20)));
}

RoundCone::RoundCone(double near, double far, double near_radius, double far_radius) noexcept
    : near_m(near),
      far_m(far),
      near_radius_m(near_radius),
      far_radius_m(far_radius),
      sine((near_radius - far_radius) / (far - near)) {
    assert(std::abs(far_radius - near_radius) < far - near);
    cosine = std::sqrt(1 - sine * sine);
}

ToolShape make_tool_shape(const ToolSpec& spec) noexcept {
    ToolShape shape;
    const double rs = spec.shaft_radius_m;
    if (spec.kind == ToolKind::kScope || spec.tip_radius_m >= rs ||
        spec.tip_length_m <= spec.tip_radius_m) {
        shape.parts[0] = {rs, std::max(spec.length_m, 2 * rs), rs, rs};
        shape.count = shape.bare_parts = 1;
        return shape;
    }
    const double rt = spec.tip_radius_m, neck = spec.tip_length_m;
    const double shoulder = neck + kShoulderSlope * (rs - rt);
    shape.parts[0] = {rt, neck, rt, rt};
    shape.parts[1] = {neck, shoulder, rt, rs};
    shape.parts[2] = {shoulder, std::max(spec.length_m, shoulder + rs), rs, rs};
    shape.count = 3;
    shape.bare_parts = 1;
    return shape;
}

// In the half plane (distance from the axis, distance behind the near end) the surface is an arc, a
// straight flank tangent to both arcs, and an arc. Source: Quilez, "Round cone" distance function.
namespace {

/// Where a point lies beside a round cone, in the half-plane of the axis.
struct ConeDistance {
    double rho = 0, s = 0;  // from the axis; behind the first centre
    double value_m = 0;
    int end = 0;  // -1 = at the first sphere, 1 = at the last, 0 = between them
};

ConeDistance cone_distance(const RoundCone& part, const Vec3& p_T) noexcept {
    ConeDistance at;
    const double h = part.far_m - part.near_m, a = part.cosine, b = part.sine;
    at.rho = length2(p_T.x(), p_T.y());
    at.s = -p_T.z() - part.near_m;
    const double k = -b * at.rho + a * at.s;
    if (k >= 0 && k <= a * h) {
        at.value_m = a * at.rho + b * at.s - part.near_radius_m;
        return at;
    }
    at.end = k < 0 ? -1 : 1;
    if (at.end > 0) at.s -= h;
    at.value_m = length2(at.rho, at.s) - (at.end < 0 ? part.near_radius_m : part.far_radius_m);
    return at;
}

}  // namespace

Distance signed_distance(const RoundCone& part, const Vec3& p_T) noexcept {
    const ConeDistance at = cone_distance(part, p_T);
    Distance d;
    d.value_m = at.value_m;
    const Vec3 radial =
        at.rho > 1e-12 ? Vec3(p_T.x() / at.rho, p_T.y() / at.rho, 0) : Vec3::UnitX();
    if (at.end == 0) {
        d.gradient = part.cosine * radial - part.sine * Vec3::UnitZ();
        return d;
    }
    const double length = length2(at.rho, at.s);
    if (length > 1e-12) {
        d.gradient = (at.rho / length) * radial - (at.s / length) * Vec3::UnitZ();
    } else {
        d.gradient = Vec3(0, 0, at.end < 0 ? 1 : -1);
    }
    return d;
}

double distance_value(const ToolShape& shape, const Vec3& p_T) noexcept {
    double best = 0;
    if (shape.spread())
        best = std::min(cone_distance(shape.parts[0], Jaw(shape, 1).seen(p_T)).value_m,
                        cone_distance(shape.parts[0], Jaw(shape, -1).seen(p_T)).value_m);
    else
        best = cone_distance(shape.parts[0], p_T).value_m;
    for (int i = 1; i < shape.count; ++i)
        best = std::min(best, cone_distance(shape.parts[i], p_T).value_m);
    return best;
}

namespace {

/// Of the first part: of the nearer jaw where they are spread.
Distance distance_to_tip(const ToolShape& shape, const Vec3& p_T) noexcept {
    if (!shape.spread()) return signed_distance(shape.parts[0], p_T);
    const Jaw left(shape, 1), right(shape, -1);
    Distance a = signed_distance(shape.parts[0], left.seen(p_T));
    Distance b = signed_distance(shape.parts[0], right.seen(p_T));
    const bool first = a.value_m <= b.value_m;
    Distance& nearer = first ? a : b;
    nearer.gradient = (first ? left : right).back(nearer.gradient);
    return nearer;
}

}  // namespace

Distance signed_distance(const ToolShape& shape, const Vec3& p_T) noexcept {
    Distance best = distance_to_tip(shape, p_T);
    for (int i = 1; i < shape.count; ++i) {
        const Distance d = signed_distance(shape.parts[i], p_T);
        if (d.value_m < best.value_m) best = d;
    }
    return best;
}

Vec3 closest_on_triangle(const Vec3& p, const Triangle& t) noexcept {
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return Vec3::UnitX();
    const Vec3 bp = p - t[1];
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return Vec3::UnitY();
    const double vc = d1 * d4 - d3 * d2;
    // Of a side without length both are 0: the next ones decide.
    if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {
        const double v = d1 / (d1 - d3);
        return {1 - v, v, 0};
    }
    const Vec3 cp = p - t[2];
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return Vec3::UnitZ();
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
        const double w = d2 / (d2 - d6);
        return {1 - w, 0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0)) return Vec3::UnitX();  // a needle triangle: any corner will do
    return {va / sum, vb / sum, vc / sum};
}

namespace {

/// A triangle that looks for the nearest part.
struct Seeker {
    explicit Seeker(const Triangle& triangle) noexcept
        : tri(triangle), centre((tri[0] + tri[1] + tri[2]) / 3) {
        size = std::sqrt(std::max({(tri[0] - centre).squaredNorm(), (tri[1] - centre).squaredNorm(),
                                   (tri[2] - centre).squaredNorm()}));
    }
    /// True where the part is nearer than what was found before.
    bool look_at(const RoundCone& part, int number, TriangleDistance& best) const noexcept;

    Triangle tri;
    Vec3 centre;
    double size = 0;
};

bool Seeker::look_at(const RoundCone& part, int number, TriangleDistance& best) const noexcept {
    // The distance changes by no more than the way, so most triangles end here.
    if (cone_distance(part, centre).value_m > best.value_m + size) return false;
    bool pierced = false;
    Vec3 w = nearest_to_axis(part, tri, pierced);
    Vec3 x = w.x() * tri[0] + w.y() * tri[1] + w.z() * tri[2];
    Distance d = signed_distance(part, x);
    if (!pierced && part.near_radius_m != part.far_radius_m) {
        // On a cone the nearest point of the axis is not the nearest sphere: descend by turns in
        // point and sphere; both sets are convex, so every turn lowers the distance.
        for (int turn = 0; turn < 8; ++turn) {
            const Vec3 centre_T(0, 0, -foot_of(part, x, d.gradient));
            const Vec3 next_w = closest_on_triangle(centre_T, tri);
            const Vec3 next = next_w.x() * tri[0] + next_w.y() * tri[1] + next_w.z() * tri[2];
            const Distance next_d = signed_distance(part, next);
            if (next_d.value_m > d.value_m - 1e-9) break;
            w = next_w;
            x = next;
            d = next_d;
        }
    }
    if (!(d.value_m < best.value_m)) return false;
    best = {d.value_m, w, d.gradient, number, pierced};
    return true;
}

}  // namespace

TriangleDistance nearest_on_triangle(const ToolShape& shape, const Triangle& tri,
                                     double limit_m) noexcept {
    TriangleDistance best;
    best.value_m = limit_m;
    const Seeker seeker(tri);
    if (shape.spread()) {
        for (const double side : {1.0, -1.0}) {
            const Jaw jaw(shape, side);
            const Seeker turned({jaw.seen(tri[0]), jaw.seen(tri[1]), jaw.seen(tri[2])});
            if (turned.look_at(shape.parts[0], 0, best)) best.gradient = jaw.back(best.gradient);
        }
    }
    for (int i = shape.spread() ? 1 : 0; i < shape.count; ++i)
        static_cast<void>(seeker.look_at(shape.parts[i], i, best));
    return best;
}

}  // namespace placode::sim

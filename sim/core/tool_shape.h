// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An instrument as a signed distance field: a chain of round cones on the shaft's axis (needle or
// probe tip, shoulder, shaft), and the point of a triangle that is nearest to it.
//
// Every part is convex, so the search on a triangle has one minimum: a thin tip cannot slip between
// vertices. Source for the idea of local optimisation on the triangle: Macklin et al. 2020, "Local
// optimization for robust signed distance field collision"; the closed forms are our own choice,
// because the axis of a part is a segment.

#include <array>

#include "sim/core/tool.h"

namespace placode::sim {

/// All spheres centred on the axis from `near_m` to `far_m` behind the tip, radius running
/// linearly.
/// @pre |far_radius - near_radius| < far - near.
struct RoundCone {
    RoundCone() = default;
    RoundCone(double near, double far, double near_radius, double far_radius) noexcept;

    double near_m = 0, far_m = 0;  ///< Distance of the end centres behind the tip [m].
    double near_radius_m = 0, far_radius_m = 0;  ///< [m]
    double cosine = 1, sine = 0;                 ///< Of the half angle, thinner backwards.
};

/// Parts from the tip backwards, in frame T. Where jaws are spread the first part stands there
/// twice, turned about x at its far end by half of the angle between them, to either side.
struct ToolShape {
    std::array<RoundCone, 3> parts{};
    int16_t count = 0;
    int16_t bare_parts = 0;  ///< The first parts are bare metal; the rest is insulated.
    float spread_sine = 0;   ///< Of half the angle between the jaws; 0 = shut.

    [[nodiscard]] bool spread() const noexcept { return spread_sine > 0; }
    /// @param jaw_rad between the jaws, 0 to 2.
    void spread_jaws(double jaw_rad) noexcept;
};

/// Shape of an instrument: tip capsule, shoulder cone, shaft capsule. Jaws are shut. The scope is a
/// plain capsule of its shaft radius.
[[nodiscard]] ToolShape make_tool_shape(const ToolSpec& spec) noexcept;

struct Distance {
    double value_m = 0;             ///< Negative inside [m].
    Vec3 gradient = Vec3::UnitX();  ///< Unit vector, away from the instrument.
};

/// Distance of `p_T` to one part: exact outside and inside.
[[nodiscard]] Distance signed_distance(const RoundCone& part, const Vec3& p_T) noexcept;

/// Distance to the instrument: exact outside. Inside it is the depth in the deepest part, a lower
/// bound of the true depth where parts overlap.
[[nodiscard]] Distance signed_distance(const ToolShape& shape, const Vec3& p_T) noexcept;

/// The value of signed_distance() alone, to the last bit: for the many places that are far away.
[[nodiscard]] double distance_value(const ToolShape& shape, const Vec3& p_T) noexcept;

/// Closest points of segment p0-p1 and segment q0-q1: returns the squared distance, `s` and `t` say
/// how far along each. Source: Ericson 2005, section 5.1.9.
double segment_segment(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, double& s,
                       double& t) noexcept;

/// Corners of a triangle.
using Triangle = std::array<Vec3, 3>;

/// Barycentric weights of the point of a triangle next to `p`. Source: Ericson 2005, section 5.1.5.
[[nodiscard]] Vec3 closest_on_triangle(const Vec3& p, const Triangle& triangle) noexcept;

/// Where a triangle comes nearest to an instrument (deepest, when they overlap).
struct TriangleDistance {
    double value_m = 1;             ///< Signed distance there [m].
    Vec3 weight = Vec3::Zero();     ///< Barycentric.
    Vec3 gradient = Vec3::UnitX();  ///< Unit vector away from the instrument.
    int part = -1;                  ///< Index of the part, -1 when farther than `limit_m`.
    bool pierced = false;  ///< The axis runs through the triangle: the gradient means nothing.
};

/// Nearest point of the triangle (in T). Parts farther than `limit_m` are skipped.
[[nodiscard]] TriangleDistance nearest_on_triangle(const ToolShape& shape,
                                                   const Triangle& triangle_T,
                                                   double limit_m) noexcept;

}  // namespace placode::sim

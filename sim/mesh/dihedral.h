// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The angle between two triangles at an edge, and its gradient. A template, so that the reference
// can differentiate the gradient once more with complex numbers.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "sim/core/portable_math.h"

namespace placode::sim {

/// Edge p0 p1, p2 the corner of the own triangle, p3 of the other one.
template <class T>
using HingePoints = std::array<Eigen::Matrix<T, 3, 1>, 4>;

namespace hinge {

/// a . b without conjugation (Eigen's dot conjugates complex numbers).
template <class T>
T dot(const Eigen::Matrix<T, 3, 1>& a, const Eigen::Matrix<T, 3, 1>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Eigen::Matrix<T, 3, 1> cross(const Eigen::Matrix<T, 3, 1>& a, const Eigen::Matrix<T, 3, 1>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace hinge

/// Positive when the other triangle stands up towards the normal of the own one, 0 when flat, in
/// (-pi, pi] [rad].
[[nodiscard]] inline double hinge_angle(const HingePoints<double>& p) noexcept {
    const Eigen::Vector3d e = p[1] - p[0];
    const Eigen::Vector3d own = e.cross(p[2] - p[0]), other = (p[3] - p[0]).cross(e);
    return atan2_portable(e.dot(other.cross(own)) / e.norm(), own.dot(other));
}

/// Gradient of the angle in the four points [1/m]: a corner lifts its triangle by one over its
/// height, and the edge takes it back, shared out as the corner stands over it.
template <class T>
[[nodiscard]] HingePoints<T> hinge_gradient(const HingePoints<T>& p) noexcept {
    using std::sqrt;
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Vector e = p[1] - p[0], to_own = p[2] - p[0], to_other = p[3] - p[0];
    const Vector own = hinge::cross<T>(e, to_own), other = hinge::cross<T>(to_other, e);
    const T e2 = hinge::dot<T>(e, e), length = sqrt(e2);
    HingePoints<T> g;
    g[2] = own * (length / hinge::dot<T>(own, own));
    g[3] = other * (length / hinge::dot<T>(other, other));
    const T a = hinge::dot<T>(to_own, e) / e2, b = hinge::dot<T>(to_other, e) / e2;
    g[0] = g[2] * (a - T(1)) + g[3] * (b - T(1));
    g[1] = g[2] * (-a) + g[3] * (-b);
    return g;
}

/// False where a triangle has shrunk to a line, so that there is no angle.
[[nodiscard]] inline bool has_hinge(const HingePoints<double>& p) noexcept {
    constexpr double kFlat = 1e-8;  // squared height over squared edge
    const Eigen::Vector3d e = p[1] - p[0];
    const double least = kFlat * e.squaredNorm() * e.squaredNorm();
    return e.cross(p[2] - p[0]).squaredNorm() > least &&
           e.cross(p[3] - p[0]).squaredNorm() > least && least > 0;
}

/// Angle from its value at rest, in (-pi, pi].
[[nodiscard]] inline double angle_from(double angle, double rest) noexcept {
    constexpr double kPi = 3.14159265358979323846;
    const double d = angle - rest;
    return d > kPi ? d - 2 * kPi : d <= -kPi ? d + 2 * kPi : d;
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Vectors, rotations and poses for every folder.
//
// Frames: W world (x cranial, y left, z outward from the back; origin at the lesion's centre, at
// rest), T tool tip (origin at the tip, +z distal along the shaft), C camera (+z into the picture,
// +x right, +y down), D device (x right, y up, z towards the operator). SI units everywhere.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace placode::sim {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// [a]x: `cross_matrix(a) * b = a.cross(b)`.
[[nodiscard]] inline Mat3 cross_matrix(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

/// Rigid pose X_AB: takes coordinates in B to coordinates in A, `p_A = q * p_B + p`.
struct Pose {
    Vec3 p = Vec3::Zero();      ///< Origin of B in A [m].
    Quat q = Quat::Identity();  ///< Rotation from B to A.

    [[nodiscard]] Vec3 operator*(const Vec3& p_B) const { return q * p_B + p; }
    [[nodiscard]] Pose operator*(const Pose& X_BC) const { return {q * X_BC.p + p, q * X_BC.q}; }
    [[nodiscard]] Pose inverse() const {
        const Quat qi = q.conjugate();
        return {qi * (-p), qi};
    }
};

}  // namespace placode::sim

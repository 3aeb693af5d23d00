// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The units in which a verification scene is given to the kernels. Private to sim/verify.

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/bounds.h"
#include "sim/solver/soft_body.h"
#include "sim/verify/verification_scene.h"

namespace placode::sim {

/// What a length, time and mass of the scene are for the kernels. A scene written in other units
/// gives the kernels the same numbers to the last digits of a double, which almost never is another
/// place of the grid: without this, motion that is not damped away differs by 0.1 to 3e-3 after
/// 0.3 s.
struct KernelUnits {
    explicit KernelUnits(const VerificationScene& scene) {
        const Eigen::AlignedBox3d box = bounds_of(scene.mesh.rest);
        origin = 0.5 * (box.min() + box.max());
        // A body of 20 mm and the density of water at 0.25 ms: the sizes of an operative field.
        length = 0.02 / box.diagonal().norm();
        time = 2.5e-4 / (scene.solver.frame_s / scene.solver.substeps);
        mass = 1000 * std::pow(length, 3) / scene.material.density_kg_m3;
    }
    double length = 1, time = 1, mass = 1;
    /// Middle of the body in the scene: floats are finest there, wherever a mesh file puts it.
    Vec3 origin = Vec3::Zero();
    /// On a grid of 1.5e-11, for bodies of 0.02: strains of tets are floats, and no finer.
    [[nodiscard]] Vec3 place(const Vec3& p) const {
        constexpr double kGrid = 0x1p-36;
        return kGrid * (length * (p - origin) / kGrid).array().round().matrix();
    }
    [[nodiscard]] Vec3 scene_place(const Vec3& p) const { return p / length + origin; }
    /// Largest coordinate of a point for the kernels.
    [[nodiscard]] double farthest(const std::vector<Vec3>& points) const {
        double most = 0;
        for (const Vec3& p : points) most = std::max(most, place(p).cwiseAbs().maxCoeff());
        return most;
    }
    [[nodiscard]] double speed() const { return length / time; }
    [[nodiscard]] double acceleration() const { return length / (time * time); }
    [[nodiscard]] double force() const { return mass * acceleration(); }
    [[nodiscard]] double stress() const { return force() / (length * length); }

    [[nodiscard]] SoftBodySpec scaled(SoftBodySpec spec) const {
        for (Vec3& p : spec.mesh.rest) p = place(p);
        for (Material& m : spec.materials) {
            m.youngs_modulus_pa *= stress();
            m.density_kg_m3 *= mass / std::pow(length, 3);
            m.damping_per_s /= time;
        }
        for (SheetTriangle& t : spec.sheet) t.thickness_m *= length;
        spec.solver.gravity_m_s2 *= acceleration();
        spec.solver.frame_s *= time;
        return spec;
    }
    [[nodiscard]] std::vector<SphereObstacle> scaled(std::vector<SphereObstacle> spheres) const {
        for (SphereObstacle& s : spheres) {
            s.centre_m = place(s.centre_m);
            s.radius_m *= length;
            s.velocity_m_s *= length;  // its time stays the scene's
        }
        return spheres;
    }
};

}  // namespace placode::sim

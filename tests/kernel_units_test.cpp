// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The same scene written in other units moves in the same way: lengths x, times x, masses x.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/verify/verification_scene.h"

namespace placode::sim {
namespace THIS_TEST {

struct Units {
    const char* name;
    double length, time, mass;
};

struct Case {
    const char* name;
    SolveMethod method;
    bool single_precision;
    /// Of positions and forces. Rounded positions are the same bits. With low parts the last digits
    /// of doubles get in where a vertex meets the ball, and grow as everything does in a motion
    /// with friction: measured 3e-6 at most.
    double same;
};

/// A beam, held at one end, that swings down onto a rising ball with friction and a load at its
/// free end: everything that has a unit.
VerificationScene scene_in(const Units& u, const Case& c) {
    const double force = u.mass * u.length / (u.time * u.time);
    VerificationScene scene;
    use_box(scene, Vec3(0.02, 0.004, 0.004) * u.length, {10, 2, 2});
    scene.material.youngs_modulus_pa = 5e3 * force / (u.length * u.length);
    scene.material.density_kg_m3 = 1000 * u.mass / std::pow(u.length, 3);
    scene.material.damping_per_s = 4 / u.time;
    scene.gravity_m_s2 = Vec3(0, 0, -2) * u.length / (u.time * u.time);
    HeldRegion fixed;
    fixed.box = {Vec3(0, 0, 0), Vec3(0, 1, 1) * u.length};
    scene.held.push_back(fixed);
    LoadRegion load;
    load.box = {Vec3(0.02, 0, 0) * u.length, Vec3(0.02, 1, 1) * u.length};
    load.total_force_n = Vec3(0, 2e-4, 0) * force;
    load.ramp_s = 0.05 * u.time;
    scene.loads.push_back(load);
    SphereObstacle ball;
    ball.centre_m = Vec3(0.017, 0.002, -0.004) * u.length;
    ball.radius_m = 0.002 * u.length;
    ball.velocity_m_s = Vec3(0, 0, 0.01) * u.length / u.time;
    ball.friction = 0.2;
    scene.spheres.push_back(ball);
    scene.solver.method = c.method;
    scene.solver.single_precision = c.single_precision;
    scene.solver.frame_s = 1e-3 * u.time;
    scene.solver.substeps = c.method == SolveMethod::kVbd ? 4 : 16;
    scene.solver.threads = 1;
    scene.end_s = 0.2 * u.time;
    scene.sample_s = 0.01 * u.time;
    return scene;
}

class KernelUnits : public testing::TestWithParam<Case> {};

TEST_P(KernelUnits, TheSameSceneInOtherUnitsGivesTheSamePicture) {
    const Units si{"SI", 1, 1, 1};
    const SolveResult a = solve(scene_in(si, GetParam()));
    ASSERT_GT(a.contact_force_n.norm(), 1e-5) << "the ball is not touched";
    double size = 0;
    const VerificationScene rest = scene_in(si, GetParam());
    for (size_t i = 0; i < a.final_m.size(); ++i)
        size += (a.final_m[i] - rest.output_points[i]).squaredNorm();
    for (const Units& u : {Units{"mm, s, g", 1e3, 1, 1e3}, Units{"mm, ms, mg", 1e3, 1e3, 1e6},
                           Units{"of its own", 37, 0.29, 1.7e-5}}) {
        const SolveResult b = solve(scene_in(u, GetParam()));
        double off = 0;
        for (size_t i = 0; i < a.final_m.size(); ++i)
            off += (b.final_m[i] / u.length - a.final_m[i]).squaredNorm();
        // A motion with contact: without units of the kernels' own it differs by 1e-4 to 3e-3.
        EXPECT_LT(std::sqrt(off / size), GetParam().same) << u.name;
        const double force = u.mass * u.length / (u.time * u.time);
        EXPECT_LT((b.contact_force_n / force - a.contact_force_n).norm(),
                  10 * GetParam().same * a.contact_force_n.norm())
            << u.name;
        EXPECT_LT((b.reaction_n / force - a.reaction_n).norm(),
                  10 * GetParam().same * a.reaction_n.norm());
        EXPECT_NEAR(b.penetration_m / u.length, a.penetration_m,
                    10 * GetParam().same * a.penetration_m + 1e-12);
        EXPECT_NEAR(b.kinetic_energy_j / (force * u.length), a.kinetic_energy_j,
                    1e-4 * a.kinetic_energy_j);
    }
}

TEST_P(KernelUnits, WhereTheBodyLiesDoesNotMatter) {
    const Units si{"SI", 1, 1, 1};
    const VerificationScene here = scene_in(si, GetParam());
    VerificationScene there = here;
    const Vec3 far(0.7, -1.3, 0.4);
    for (Vec3& p : there.mesh.rest) p += far;
    for (Vec3& p : there.output_points) p += far;
    for (HeldRegion& r : there.held) r.box = {r.box.low + far, r.box.high + far};
    for (LoadRegion& r : there.loads) r.box = {r.box.low + far, r.box.high + far};
    for (SphereObstacle& s : there.spheres) s.centre_m += far;
    const SolveResult a = solve(here), b = solve(there);
    double off = 0, size = 0;
    for (size_t i = 0; i < a.final_m.size(); ++i) {
        off += (b.final_m[i] - far - a.final_m[i]).squaredNorm();
        size += (a.final_m[i] - here.output_points[i]).squaredNorm();
    }
    // A float resolves 0.12 um at 1.3 m, more than a substep moves the beam.
    EXPECT_LT(std::sqrt(off / size), GetParam().same);
}

INSTANTIATE_TEST_SUITE_P(Methods, KernelUnits,
                         testing::Values(Case{"vbd_rounded", SolveMethod::kVbd, true, 1e-6},
                                         Case{"xpbd_rounded", SolveMethod::kXpbd, true, 1e-6},
                                         Case{"vbd", SolveMethod::kVbd, false, 1e-5},
                                         Case{"xpbd", SolveMethod::kXpbd, false, 1e-5}),
                         [](const auto& info) { return info.param.name; });

}  // namespace THIS_TEST
}  // namespace placode::sim

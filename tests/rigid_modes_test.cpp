// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that nothing holds: what moves them as a whole is Newton's law, whatever the sweeps of a
// substep have found.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "solve_scene.h"

using namespace placode;
using namespace placode::test;
using placode::sim::SolveResult;

namespace THIS_TEST {

/// Ways of implicit steps of h under a constant acceleration: a T (T + h) / 2.
double implicit_displacement(double acceleration, double time_s, double h) {
    return acceleration * time_s * (time_s + h) / 2;
}

/// Mean place of the first probe at the end, less where it was.
sim::Vec3 displacement_of(const SolveResult& r) {
    return r.probe_m.back().front() - r.probe_m.front().front();
}

/// The head of a scene: a bar of 2 g without gravity.
std::string bar(double youngs_modulus_pa) {
    return R"({"mesh": {"box": {"size_m": [0.02,0.01,0.01], "cells": [4,2,2]}},
               "gravity_m_s2": [0,0,0],
               "material": {"poissons_ratio": 0.3, "youngs_modulus_pa": )" +
           std::to_string(youngs_modulus_pa) + "}, ";
}

const char* const kAll = R"("probes": [{"name": "all", "box_m": [[-1,-1,-1],[1,1,1]]}])";

TEST(RigidModes, ABarPushedAtOneEndGoesWhereNewtonsLawSendsIt) {
    // 2 g, 2 mN for 0.4 s. Courant numbers 0.5 and 0.1: without the modes 14 and 4 % less.
    for (const auto& [method, substeps] : {std::pair{"vbd", 1}, {"vbd", 8}, {"xpbd", 8}}) {
        const SolveResult r = run(bar(5000) + R"("until": {"time_s": 0.4},
                "loads": [{"box_m": [[0,-1,-1],[0,1,1]], "total_force_n": [0.002,0,0]}], )" +
                                  std::string(kAll) + ", " + solver(method, substeps) + "}");
        const sim::Vec3 offset = displacement_of(r);
        EXPECT_NEAR(offset.x(), implicit_displacement(1, 0.4, 1e-3 / substeps), 1e-3 * offset.x())
            << method;
        EXPECT_LT(offset.tail<2>().norm(), 1e-4 * offset.x()) << "sideways, " << method << substeps;
    }
}

TEST(RigidModes, ACoupleGivesTheAngularMomentumThatItShould) {
    // Equal and opposite forces across both ends for 20 ms: couple times time.
    for (const auto& [method, substeps] : {std::pair{"vbd", 2}, {"xpbd", 8}, {"xpbd_pair", 8}}) {
        const SolveResult r = run(bar(50000) + R"("until": {"time_s": 0.02},
                "loads": [{"box_m": [[0,-1,-1],[0,1,1]], "total_force_n": [0,0.002,0]},
                          {"box_m": [[0.02,-1,-1],[1,1,1]], "total_force_n": [0,-0.002,0]}], )" +
                                  solver(method, substeps) + "}");
        const double expected = -0.02 * 0.002 * 0.02;
        // The ends come 0.3 % nearer to each other's line of force, for the body turns.
        EXPECT_NEAR(r.angular_momentum_kg_m2_s.z(), expected, 5e-3 * std::abs(expected))
            << method << substeps;
        EXPECT_LT(r.momentum_kg_m_s.norm(), 1e-5 * r.momentum_scale_kg_m_s) << method << substeps;
    }
}

TEST(RigidModes, WhatOnlyOtherAxesHoldMovesAlongTheFreeOne) {
    for (const auto& [method, substeps] : {std::pair{"vbd", 1}, {"vbd", 8}, {"xpbd", 8}}) {
        const SolveResult r = run(
            R"({"mesh": {"box": {"size_m": [0.02,0.01,0.01], "cells": [4,2,2]}},
                "material": {"youngs_modulus_pa": 5000, "poissons_ratio": 0.3},
                "gravity_m_s2": [1,0,-9.81], "until": {"time_s": 0.2},
                "fixed": [{"box_m": [[-1,-1,0],[1,1,0]], "axes": "yz"}], )" +
            std::string(kAll) + ", " + solver(method, substeps) + "}");
        const double path = displacement_of(r).x();
        EXPECT_NEAR(path, implicit_displacement(1, 0.2, 1e-3 / substeps), 1e-3 * path)
            << method << substeps;
    }
}

TEST(RigidModes, ABlockSlidesDownASlopeAsCoulombSays) {
    // Gravity across a sphere of 100 m: 4 m/s^2 along, 8 into it, so a = 4 - 8 mu. 2 g of 20 kPa,
    // let go 10 um above: it chatters, and the friction of short contacts must not be lost. Without
    // the modes 0 to 7 mm.
    for (const auto& [method, substeps] : {std::pair{"vbd", 8}, {"vbd", 32}, {"xpbd", 32}}) {
        for (const double friction : {0.0, 0.3}) {
            const SolveResult r = run(
                R"({"mesh": {"box": {"size_m": [0.02,0.02,0.005], "cells": [4,4,1]}},
                    "material": {"youngs_modulus_pa": 20000, "poissons_ratio": 0.3},
                    "gravity_m_s2": [4,0,-8], "until": {"time_s": 0.1},
                    "sdf_contacts": [{"sphere": {"centre_m": [0.01,0.01,-100.00001],
                                                 "radius_m": 100}, "friction": )" +
                std::to_string(friction) + "}], " + kAll + ", " + solver(method, substeps) + "}");
            const double expected = implicit_displacement(4 - 8 * friction, 0.1, 1e-3 / substeps);
            EXPECT_NEAR(displacement_of(r).x(), expected, (friction > 0 ? 0.05 : 0.01) * expected)
                << method << substeps << ", friction " << friction;
        }
    }
}

TEST(RigidModes, AnImpactWithFrictionGivesNoKickAcross) {
    // 5 mm down onto a sphere that lies in the plane of symmetry y = 10 mm, but for the diagonals
    // of the mesh: explicit steps carry the block 0.3 to 0.7 mm across in 0.15 s, and touched
    // vertices that begin a substep deep in the sphere 2.2 mm.
    for (const char* method : {"vbd", "xpbd"}) {
        const SolveResult r = run(
            R"({"mesh": {"box": {"size_m": [0.02,0.02,0.02], "cells": [3,3,3]}},
                "sdf_contacts": [{"sphere": {"centre_m": [0.02,0.01,-0.105], "radius_m": 0.1},
                                  "friction": 0.5}], "until": {"time_s": 0.15}, )" +
            std::string(kAll) + ", " + solver(method, 8) + "}");
        EXPECT_NEAR(displacement_of(r).y(), 0, 0.001) << method;
        EXPECT_GT(r.kinetic_energy_j, 0) << method;
        EXPECT_LT(r.kinetic_energy_j + r.elastic_energy_j, 0.008 * 9.81 * 0.02) << method;
    }
}

TEST(RigidModes, ASphereOnAHeldPieceLeavesTheFreeOneAlone) {
    // Two cubes of 10 mm, 20 mm apart, without gravity: the second is held and pressed.
    const sim::TetMesh cube = sim::box_mesh({0.01, 0.01, 0.01}, {2, 2, 2});
    sim::TetMesh both = cube;
    const auto first = static_cast<int32_t>(cube.rest.size());
    for (const sim::Vec3& p : cube.rest) both.rest.push_back(p + sim::Vec3(0.03, 0, 0));
    for (auto tet : cube.tets) {
        for (int32_t& v : tet) v += first;
        both.tets.push_back(tet);
    }
    both.tissue.assign(both.tets.size(), sim::Tissue::kSubcutis);
    std::vector<int32_t> same(both.rest.size());
    std::iota(same.begin(), same.end(), 0);
    for (const auto method : {sim::SolveMethod::kVbd, sim::SolveMethod::kXpbd}) {
        sim::VerificationScene scene;
        sim::use_mesh(scene, both, both.rest, same);
        scene.gravity_m_s2.setZero();
        sim::HeldRegion base;
        base.pointer = "/fixed/0";
        base.box = {sim::Vec3(0.03, 0, 0), sim::Vec3(1, 1, 0)};
        scene.held.push_back(base);
        scene.spheres.push_back({sim::Vec3(0.035, 0.005, 0.0195), 0.01, sim::Vec3::Zero(), 0.3});
        scene.probes.push_back({"free", {sim::Vec3(0, 0, 0), sim::Vec3(0.01, 1, 1)}, "/probes/0"});
        scene.solver.method = method;
        scene.end_s = 0.05;
        const SolveResult r = sim::solve(scene);
        EXPECT_GT(r.contact_force_n.z(), 0.01);
        EXPECT_LT(displacement_of(r).norm(), 1e-7) << sim::method_name(method);
    }
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres in verification scenes: what they press on presses back, and friction.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solve_scene.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using placode::sim::SolveResult;
using ::testing::HasSubstr;

TEST(SolveContact, ASphereIsPressedBackByWhatItPressesOn) {
    // Equilibrium: the support carries what the sphere does, whatever the law of contact.
    for (const auto& [method, substeps] :
         {std::pair{"vbd", 16}, {"xpbd", 16}, {"explicit", 24}, {"newton", 1}}) {
        const SolveResult r = run(
            R"({"mesh": {"box": {"size_m": [0.006,0.006,0.004], "cells": [6,6,4]}},
                "gravity_m_s2": [0,0,0], "damping_per_s": 100,
                "fixed": [{"box_m": [[0,0,0],[1,1,0]]}],
                "sdf_contacts": [{"sphere": {"centre_m": [0.003,0.003,0.0065], "radius_m": 0.002},
                                  "velocity_m_s": [0,0,-0.005], "friction": 0}],
                "until": {"time_s": 0.2}, )" +
            solver(method, substeps) + "}");
        // 0.5 mm deep at the end, at 5 mm/s: inertia and damping take a small share.
        EXPECT_LT(r.contact_force_n.z() * -1, 0) << method;
        EXPECT_NEAR(r.contact_force_n.z(), r.reaction_n.z(), 0.08 * r.contact_force_n.z())
            << method;
        EXPECT_LT(r.penetration_m, 1e-4) << method;  // explicit: as stiff as its step bears
        EXPECT_EQ(r.inverted_tets, 0) << method;
    }
}

TEST(SolveContact, TheForceOnASphereIsThatOfNewtonOnTheSameGradedMesh) {
    // Edges of 0.3 mm below the sphere and of 2 mm at the sides: a contact as stiff as the mean
    // edge asks for would burst on the small ones. Newton itself must come to an end.
    double force[2]{};
    for (const bool fast : {false, true}) {
        sim::VerificationScene scene = curriculum::verification_scene_from_json(
            R"({"mesh": {"box": {"size_m": [0.008,0.008,0.008], "cells": [8,8,8]}},
                "material": {"youngs_modulus_pa": 50000, "poissons_ratio": 0.45, "density_kg_m3": 1000},
                "gravity_m_s2": [0,0,0], "damping_per_s": 100,
                "fixed": [{"box_m": [[-1,-1,0],[1,1,0]], "axes": "xyz"}],
                "sdf_contacts": [{"sphere": {"centre_m": [0,0,0.013], "radius_m": 0.005},
                                  "velocity_m_s": [0,0,-0.001], "friction": 0}],
                "until": {"time_s": 0.2}, )" +
                solver(fast ? "vbd" : "newton", 4) + "}",
            "scene.json", ".");
        for (std::vector<sim::Vec3>* points : {&scene.mesh.rest, &scene.output_points}) {
            for (sim::Vec3& p : *points) {
                for (int a = 0; a < 3; ++a) {
                    const double t = p[a] / 0.008;
                    p[a] = a < 2 ? 0.008 * t * (0.3 + 0.7 * t) : 0.008 * t * (1.7 - 0.7 * t);
                }
            }
        }
        const SolveResult result = curriculum::solve_verification_scene(scene, "scene.json");
        EXPECT_FALSE(result.diverged);
        EXPECT_EQ(result.inverted_tets, 0);
        force[fast] = result.contact_force_n.z();
    }
    EXPECT_GT(force[0], 1e-3);
    // 0.2 s at 1 mm/s and penalty contacts of different stiffness: 2 %.
    EXPECT_NEAR(force[1] / force[0], 1, 0.02);
}

TEST(SolveContact, SaysWhenASphereBeginsInsideTheTissue) {
    const auto with = [](const char* centre) {
        return run(cube(R"("until": {"time_s": 0.001}, "sdf_contacts": [{"sphere": {"centre_m": )" +
                        std::string(centre) + R"(, "radius_m": 0.0003}}], )" + solver("vbd", 4)))
            .warnings;
    };
    for (const char* inside : {"[0.0004, 0.0011, 0.0013]", "[0.001, 0.001, 0.001]"})
        EXPECT_THAT(with(inside),
                    ::testing::Contains(HasSubstr("/sdf_contacts/0: the centre begins inside")));
    EXPECT_THAT(with("[0.0004, 0.0011, 0.0023]"),
                ::testing::Not(::testing::Contains(HasSubstr("the centre begins inside"))));
}

TEST(SolveContact, SaysWhenHeldTissueBeginsInsideASphere) {
    const auto with = [](const char* centre) {
        return run(cube(kRollers + R"(, "prescribed": [{"box_m": [[0,0,0],[1,1,0]],
                            "displacement_m": [0,0,0]}], "gravity_m_s2": [0,0,0],
                            "until": {"time_s": 0.001}, "sdf_contacts": [{"sphere":
                            {"centre_m": )" +
                        std::string(centre) + R"(, "radius_m": 0.01}}], )" + solver("vbd", 4)))
            .warnings;
    };
    EXPECT_THAT(with("[0.001, 0.001, 0.008]"),
                ::testing::Contains(HasSubstr("/sdf_contacts/0: 9 held vertices begin inside it")));
    EXPECT_THAT(with("[0.001, 0.001, 0.0115]"),
                ::testing::Not(::testing::Contains(HasSubstr("/sdf_contacts"))));
    EXPECT_THAT(refusal(cube(R"("sdf_contacts": [{"sphere": {"centre_m": [1e300, 0, 0],
                                "radius_m": 0.01}}])")),
                HasSubstr("/sdf_contacts/0/sphere/centre_m"));
}

TEST(SolveContact, FrictionHoldsATangentialPullUpToTheCone) {
    // The sphere sits 0.4 mm deep and moves sideways: with friction it drags the surface along.
    double side[2]{};
    for (int i = 0; i < 2; ++i) {
        const SolveResult r = run(
            R"({"mesh": {"box": {"size_m": [0.006,0.006,0.004], "cells": [6,6,4]}},
                "gravity_m_s2": [0,0,0], "damping_per_s": 100,
                "fixed": [{"box_m": [[0,0,0],[1,1,0]]}],
                "sdf_contacts": [{"sphere": {"centre_m": [0.0025,0.003,0.0056], "radius_m": 0.002},
                                  "velocity_m_s": [0.002,0,0], "friction": )" +
            std::string(i == 0 ? "0" : "0.3") + R"(}], "until": {"time_s": 0.3}, )" +
            solver("vbd", 4) + "}");
        side[i] = -r.contact_force_n.x() / r.contact_force_n.z();
    }
    // Sliding: the tangential force is mu times the normal one (the surface's slope adds a little).
    EXPECT_NEAR(side[1] - side[0], 0.3, 0.06);
}

}  // namespace THIS_TEST

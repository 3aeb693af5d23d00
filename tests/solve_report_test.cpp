// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that ask for something odd: it is done as it was written, or it is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solve_scene.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using placode::sim::SolveResult;
using ::testing::Contains;
using ::testing::HasSubstr;

TEST(SolveReport, NumbersStandInTheOrderOfTheAxesNamed) {
    for (const auto& [axes, numbers] :
         {std::pair{"xz", "0.0002, 0"}, {"zx", "0, 0.0002"}, {"x", "0.0002"}}) {
        const SolveResult r =
            run(cube(R"("gravity_m_s2": [0,0,0], "fixed": [{"box_m": [[0,0,0],[0,1,1]]}],
                    "prescribed": [{"box_m": [[0.002,0,0],[1,1,1]], "axes": ")" +
                     std::string(axes) + R"(", "displacement_m": [)" + numbers + R"(]}],
                    "probes": [{"name": "end", "box_m": [[0.002,0,0],[1,1,1]]}], )" +
                     solver("newton", 1)));
        const sim::Vec3 offset = r.probe_m.back().front() - r.probe_m.front().front();
        EXPECT_NEAR(offset.x(), 0.0002, 1e-9) << axes;
        EXPECT_NEAR(offset.z(), 0, 5e-5) << axes;  // where z is free it contracts
    }
}

TEST(SolveReport, ATimeThatIsNoWholeNumberOfSubstepsIsKept) {
    // Free fall: after 0.1 s 0.049 m, and not where a substep of 0.5 s ends.
    for (const char* method : {"vbd", "explicit"}) {
        const SolveResult r = run(cube(
            R"("until": {"time_s": 0.0101}, "probes": [{"name": "all", "box_m": [[0,0,0],[1,1,1]]}], )" +
            solver(method, 30)));
        EXPECT_NEAR(r.simulated_s, 0.0101, 1e-12) << method;
    }
    const SolveResult r = run(cube(
        R"("until": {"time_s": 0.1}, "probes": [{"name": "all", "box_m": [[0,0,0],[1,1,1]]}],
           "solver": {"method": "vbd", "frame_s": 0.5, "substeps": 1, "threads": 1})"));
    EXPECT_NEAR(r.simulated_s, 0.1, 1e-12);
    EXPECT_EQ(r.substeps_total, 1);
}

TEST(SolveReport, NewtonThatEndsInTheMiddleOfARampIsNotAtRest) {
    const std::string scene = kRollers + R"(, "gravity_m_s2": [0,0,0],
        "loads": [{"box_m": [[0.002,0,0],[1,1,1]], "total_force_n": [0.001,0,0], "ramp_s": 30}], )" +
                              solver("newton", 1);
    const SolveResult early = run(cube(scene + R"(, "until": {"rest": {}})"));
    EXPECT_FALSE(early.at_rest);
    EXPECT_THAT(early.warnings, Contains(HasSubstr("a ramp takes 30 s")));
    EXPECT_NEAR(early.reaction_n.x(), -0.001 * 20 / 30, 1e-9);
    const SolveResult whole = run(cube(scene + R"(, "until": {"rest": {"max_s": 40}})"));
    EXPECT_TRUE(whole.at_rest);
    EXPECT_NEAR(whole.reaction_n.x(), -0.001, 1e-9);
}

TEST(SolveReport, TheReactionIsOfWhatStillHolds) {
    // The prescribed region takes all of the fixed one over.
    const SolveResult r =
        run(cube(R"("gravity_m_s2": [0,0,-9.81], "fixed": [{"box_m": [[0,0,0],[1,1,0]]}],
                "prescribed": [{"box_m": [[0,0,0],[1,1,0]], "displacement_m": [0,0,0]}], )" +
                 solver("newton", 1)));
    const double weight = 1000 * 8e-9 * 9.81;
    EXPECT_NEAR(r.reaction_n.z(), weight, 1e-3 * weight);
    EXPECT_NEAR(r.reactions[0].force_n.norm(), 0, 1e-12);
    EXPECT_NEAR(r.reactions[1].force_n.z(), weight, 1e-3 * weight);
}

TEST(SolveReport, KeysWithoutEffectAreNamed) {
    const auto warnings = [](const std::string& more) { return run(cube(more)).warnings; };
    const std::string shortly = R"("until": {"time_s": 0.001}, )";
    EXPECT_THAT(warnings(shortly + solver("xpbd", 16, R"(, "over_relaxation": 1.1)")),
                Contains("/solver/over_relaxation: has no effect with xpbd"));
    EXPECT_THAT(warnings(shortly + solver("explicit", 40, R"(, "iterations": 2)")),
                Contains("/solver/iterations: has no effect with explicit"));
    EXPECT_THAT(warnings(shortly + solver("explicit", 40, R"(, "single_precision": true)")),
                Contains("/solver/single_precision: has no effect with explicit"));
    EXPECT_THAT(
        warnings(shortly + R"("start": {"kind": "rest", "amount": 1}, )" + solver("vbd", 8)),
        Contains("/start/amount: has no effect with rest"));
    EXPECT_THAT(warnings(shortly + R"("fixed": [{"box_m": [[0,0,0],[1,1,0]]}],
                    "loads": [{"box_m": [[0,0,0],[1,1,0]], "total_force_n": [0,0,1]}], )" +
                         solver("vbd", 8)),
                Contains(HasSubstr("/loads/0: acts on held coordinates only")));
    EXPECT_THAT(warnings(shortly + solver("vbd", 8, R"(, "iterations": 2)")),
                ::testing::Not(Contains(HasSubstr("no effect"))));
}

TEST(SolveReport, TissueThatCollapsedHasDiverged) {
    // A soft cantilever of 40 mm under its weight; below a Poisson's ratio of 0 a point has less
    // energy than the rest shape.
    const std::string scene =
        R"({"mesh": {"box": {"size_m": [0.04,0.01,0.01], "cells": [16,4,4]}},
            "fixed": [{"box_m": [[0,-1,-1],[0,1,1]]}], "until": {"rest": {}},
            "solver": {"method": "newton"}, "material": {"youngs_modulus_pa": 5000, )";
    const SolveResult r = run(scene + R"("poissons_ratio": -0.5}})");
    EXPECT_TRUE(r.diverged);
    EXPECT_FALSE(r.at_rest);
    EXPECT_THAT(r.warnings, Contains(HasSubstr("collapsed")));
    const SolveResult stiffer = run(scene + R"("density_kg_m3": 10, "poissons_ratio": -0.5}})");
    EXPECT_FALSE(stiffer.diverged);
    EXPECT_TRUE(stiffer.at_rest);
}

}  // namespace THIS_TEST

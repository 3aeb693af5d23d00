// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets in verification scenes: where their triangles come from, what they are welded to, what is
// refused, and that every method that takes them finds the same equilibrium.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "curriculum/verification_json.h"

using namespace placode;
using placode::sim::SolveResult;
using ::testing::HasSubstr;

namespace THIS_TEST {

const std::string kMeshes = PLACODE_SOURCE_DIR "/tests/data/meshes/";

sim::VerificationScene load(const std::string& text, const std::string& folder = ".") {
    return curriculum::verification_scene_from_json(text, "scene.json", folder);
}

SolveResult run(const std::string& text) {
    return curriculum::solve_verification_scene(load(text), "scene.json");
}

std::string refusal(const std::string& text, const std::string& folder = ".") {
    try {
        (void)curriculum::solve_verification_scene(load(text, folder), "scene.json");
    } catch (const curriculum::DefinitionError& error) {
        return error.what();
    }
    return "accepted";
}

/// A block of 3 x 2 x 2 mm held at x = 0, and a flap of 3 x 2 mm welded to its other end.
std::string flap(const std::string& method, const std::string& sheet = "", int substeps = 4) {
    return R"({"mesh": {"box": {"size_m": [0.003, 0.002, 0.002], "cells": [3, 2, 2]}},
        "material": {"youngs_modulus_pa": 20000}, "damping_per_s": 30,
        "sheets": [{"grid": {"origin_m": [0.003, 0, 0.001], "u_m": [0.003, 0, 0],
                             "v_m": [0, 0.002, 0], "cells": [3, 2]},
                    "thickness_m": 0.0002, "youngs_modulus_pa": 200000)" +
           sheet + R"(}], "fixed": [{"box_m": [[0,0,0],[0,1,1]]}],
        "probes": [{"name": "tip", "box_m": [[0.006, 0, 0], [0.006, 1, 1]]}], "sample_s": 0.05,
        "until": {"time_s": 1.0}, "solver": {"method": ")" +
           method + R"(", "threads": 1, "substeps": )" + std::to_string(substeps) + "}}";
}

TEST(SheetScene, AWeldedFlapSagsTheSameWithEveryMethodThatTakesIt) {
    const SolveResult truth = run(flap("newton"));
    const double sag = 0.001 - truth.probe_m.back()[0].z();
    ASSERT_GT(sag, 1e-5);
    // Weight of block and flap, with the masses of both.
    const double mass = 1000 * (0.003 * 0.002 * 0.002 + 0.003 * 0.002 * 0.0002);
    EXPECT_NEAR(truth.reaction_n.z(), 9.81 * mass, 1e-9 * mass);
    for (const auto& [method, substeps] : {std::pair{"vbd", 4}, {"explicit", 64}}) {
        const SolveResult result = run(flap(method, "", substeps));
        EXPECT_FALSE(result.diverged) << method;
        EXPECT_NEAR(0.001 - result.probe_m.back()[0].z(), sag, 0.01 * sag) << method;
    }
}

TEST(SheetScene, TheWeldSharesVerticesAndTheRestIsAppended) {
    const sim::VerificationScene scene = load(flap("vbd"));
    EXPECT_EQ(scene.sheet.size(), 12u);
    EXPECT_EQ(scene.output_points.size(), 36u + 9u);  // three of the flap's 12 points are welded
    EXPECT_EQ(scene.mesh.rest.size(), 45u);
    for (size_t p = 0; p < scene.output_points.size(); ++p) {
        const auto v = static_cast<size_t>(scene.vertex_of_output[p]);
        EXPECT_EQ(scene.mesh.rest[v], scene.output_points[p]) << p;
    }
}

TEST(SheetScene, FacesInABoxBecomeASheetAndStiffenTheBlock) {
    const std::string block = R"({"mesh": {"box": {"size_m": [0.004, 0.002, 0.001],
        "cells": [4, 2, 1]}}, "fixed": [{"box_m": [[0,0,0],[0,1,1]]}],
        "probes": [{"name": "tip", "box_m": [[0.004, 0, 0], [0.004, 1, 1]]}],
        "solver": {"method": "newton"})";
    const SolveResult soft = run(block + "}");
    const SolveResult skinned =
        run(block + R"(, "sheets": [{"box_m": [[0, 0, 0.001], [1, 1, 0.001]],
            "thickness_m": 1e-4, "youngs_modulus_pa": 1e6, "density_kg_m3": 1}]})");
    // 0.77: stiff on one side only, and one layer of linear tets locks by itself.
    EXPECT_LT(0.0005 - skinned.probe_m.back()[0].z(), 0.85 * (0.0005 - soft.probe_m.back()[0].z()));
}

TEST(SheetScene, AMembraneAloneNeedsNoTets) {
    // Hung at its upper edge: rho g L^2 / (2 E); held sideways there, 5 % as in sheet_test.
    const SolveResult result = run(R"({"sheets": [{"grid": {"origin_m": [0, 0, 0],
        "u_m": [0.001, 0, 0], "v_m": [0, 0, -0.01], "cells": [1, 10]}, "thickness_m": 1e-4}],
        "fixed": [{"box_m": [[0, 0, 0], [1, 0, 0]]}], "damping_per_s": 100,
        "probes": [{"name": "low", "box_m": [[0, 0, -0.01], [1, 0, -0.01]]}],
        "until": {"rest": {}}, "solver": {"threads": 1}})");
    EXPECT_TRUE(result.at_rest);
    const double sag = 1000 * 9.81 * 1e-4 / (2 * 5000);
    EXPECT_NEAR(-0.01 - result.probe_m.back()[0].z(), sag, 0.05 * sag);
}

TEST(SheetScene, TrianglesOfTheMeshFileAreTakenByGroup) {
    for (const char* file : {"box_gmsh22_ascii.msh", "box_gmsh22_binary.msh", "box_gmsh1.msh",
                             "box_vtk42_ascii.vtk", "box_ascii.vtu"}) {
        const sim::VerificationScene scene =
            load(std::string(R"({"mesh": {"file": ")") + file +
                     R"(", "scale": 0.001}, "sheets": [{"group": "all", "thickness_m": 1e-4}]})",
                 kMeshes);
        ASSERT_EQ(scene.sheet.size(), 2u) << file;
        EXPECT_EQ(scene.mesh.rest.size(), 8u) << file;  // welded by number
        for (const std::string& warning : scene.warnings)
            EXPECT_EQ(warning.find("cells: triangle"), std::string::npos) << warning;
    }
    const std::string surface = R"({"mesh": {"file": "box_gmsh41_ascii.msh", "scale": 0.001},
        "sheets": [{"group": )";
    EXPECT_EQ(load(surface + R"(1, "thickness_m": 1e-4}]})", kMeshes).sheet.size(), 2u);
    EXPECT_THAT(
        refusal(surface + R"(7, "thickness_m": 1e-4}]})", kMeshes),
        HasSubstr("/sheets/0/group: found 7; expected \"all\" or a group with triangles: 1"));
}

TEST(SheetScene, ASheetFromAFileOfItsOwnIsWeldedByPlace) {
    const sim::VerificationScene scene =
        load(R"({"mesh": {"box": {"size_m": [0.001, 0.002, 0.003], "cells": [1, 1, 1]}},
             "sheets": [{"file": "box_gmsh22_ascii.msh", "scale": 0.001, "thickness_m": 1e-4}]})",
             kMeshes);
    EXPECT_EQ(scene.sheet.size(), 2u);
    EXPECT_EQ(scene.mesh.rest.size(), 8u);
}

TEST(SheetScene, SpheresTouchASheetFromBothSides) {
    const auto push = [](const char* centre, const char* velocity) {
        return run(std::string(R"({"sheets": [{"grid": {"origin_m": [0, 0, 0], "u_m": [0.006, 0, 0],
            "v_m": [0, 0.006, 0], "cells": [6, 6]}, "thickness_m": 2e-4}],
            "fixed": [{"box_m": [[0, 0, 0], [0, 1, 0]]}, {"box_m": [[0.006, 0, 0], [0.006, 1, 0]]}],
            "gravity_m_s2": [0, 0, 0], "damping_per_s": 50, "until": {"time_s": 0.2},
            "sdf_contacts": [{"sphere": {"centre_m": )") +
                   centre + R"(, "radius_m": 0.0015}, "velocity_m_s": )" + velocity +
                   R"(}], "solver": {"threads": 1, "substeps": 4}})");
    };
    const SolveResult above = push("[0.003, 0.003, 0.0016]", "[0, 0, -0.003]");
    const SolveResult below = push("[0.003, 0.003, -0.0016]", "[0, 0, 0.003]");
    EXPECT_GT(above.contact_force_n.z(), 1e-5);
    EXPECT_NEAR(below.contact_force_n.z(), -above.contact_force_n.z(),
                0.02 * above.contact_force_n.z());
    EXPECT_LT(above.penetration_m, 5e-5);
}

TEST(SheetScene, RefusesWhatCannotBe) {
    EXPECT_THAT(refusal(flap("xpbd", "", 64)),
                HasSubstr("/solver/method: found xpbd, which knows tetrahedra only, and 12 "
                          "triangles of sheets; expected vbd, explicit or newton"));
    EXPECT_THAT(refusal(flap("vbd", R"(, "poissons_ratio": 0.5)")),
                HasSubstr("/sheets/0/poissons_ratio: found 0.5; expected a number above -1"));
    EXPECT_THAT(refusal(flap("vbd", R"(, "thickness_mm": 1)")),
                HasSubstr("/sheets/0/thickness_mm: unknown key; expected one of: box_m"));
    EXPECT_THAT(refusal(flap("vbd", R"(, "group": 3)")),
                HasSubstr("expected one of \"box_m\", \"group\", \"file\" and \"grid\""));
    const auto with = [](const std::string& sheet) {
        return refusal(R"({"mesh": {"box": {"size_m": [0.001, 0.001, 0.001], "cells": [1, 1, 1]}},
                       "sheets": [)" +
                       sheet + "]}");
    };
    EXPECT_THAT(with(R"({"group": 1, "thickness_m": 1e-4})"),
                HasSubstr("/sheets/0/group: belongs to a \"mesh\" from a file"));
    EXPECT_THAT(with(R"({"box_m": [[0,0,0.0005],[1,1,1]], "thickness_m": 0})"),
                HasSubstr("/sheets/0/thickness_m: found 0; expected a number from 1e-24"));
    EXPECT_THAT(with(R"({"box_m": [[0,0,0.0005],[1,1,1]], "thickness_m": 1e-4})"),
                HasSubstr("accepted"));
    EXPECT_THAT(with(R"({"box_m": [[0,0,0.0005],[1,1,0.0007]], "thickness_m": 1e-4})"),
                HasSubstr("/sheets/0/box_m: found"));
    EXPECT_THAT(with(R"({"grid": {"origin_m": [1,0,0], "u_m": [0.001,0,0], "v_m": [0,0.001,0],
                       "cells": [1,1]}, "thickness_m": 1e-4})"),
                HasSubstr("/sheets/0: none of its 4 points is a vertex of the mesh"));
    EXPECT_THAT(with(R"({"grid": {"origin_m": [0,0,0], "u_m": [0.001,0,0], "v_m": [0.002,0,0],
                       "cells": [1,1]}, "thickness_m": 1e-4})"),
                HasSubstr("/sheets/0/grid/v_m: found [0.002,0,0]; expected a direction beside"));
    EXPECT_THAT(with(R"({"box_m": [[0,0,0.001],[1,1,1]], "thickness_m": 1e-4},
                       {"box_m": [[0,0,0.001],[1,1,1]], "thickness_m": 1e-4})"),
                HasSubstr("/sheets/1: sheet triangle 0: duplicate of triangle 0 of another sheet"));
    EXPECT_THAT(refusal(R"({"sheets": []})"),
                HasSubstr("/sheets: found []; expected at least one"));
    EXPECT_THAT(refusal(R"({"solver": {}})"), HasSubstr("the key \"mesh\" is missing"));
}

}  // namespace THIS_TEST

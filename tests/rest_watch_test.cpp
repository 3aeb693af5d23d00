// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// When a verification scene stops: what is slow without being there goes on, what settles beside
// the equilibrium says how far. The reference is `newton` on the same mesh.
#include "sim/verify/rest_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace placode::sim;
using ::testing::Contains;
using ::testing::HasSubstr;

namespace THIS_TEST {

/// A short cantilever under a weak weight.
VerificationScene cantilever(SolveMethod method, int substeps, double damping_per_s) {
    VerificationScene scene;
    use_box(scene, Vec3(0.02, 0.01, 0.01), {8, 4, 4});
    scene.material.damping_per_s = damping_per_s;
    scene.gravity_m_s2 = Vec3(0, 0, -1);
    scene.held.push_back({{Vec3(0, 0, 0), Vec3(0, 1, 1)}, 7, Vec3::Zero(), 0, "/fixed/0"});
    scene.solver.method = method;
    scene.solver.substeps = substeps;
    scene.solver.threads = 1;
    scene.rest_speed_m_s = 1e-4;
    scene.end_s = 20;
    return scene;
}

/// Farthest vertex from where newton has it [m]; the largest displacement there.
std::pair<double, double> distance(VerificationScene scene, const SolveResult& result) {
    scene.solver.method = SolveMethod::kNewton;
    const SolveResult expected = solve(scene);
    double distance_m = 0, moved_m = 0;
    for (size_t v = 0; v < expected.final_m.size(); ++v) {
        distance_m = std::max(distance_m, (result.final_m[v] - expected.final_m[v]).norm());
        moved_m = std::max(moved_m, (expected.final_m[v] - scene.output_points[v]).norm());
    }
    return {distance_m, moved_m};
}

bool says(const SolveResult& result, const char* what) {
    return ::testing::Value(result.warnings, Contains(HasSubstr(what)));
}

TEST(RestWatch, TissueThatCreepsGoesOnUntilItIsThere) {
    // 2,000 / s: slower than 0.1 mm/s when 11 % of the way are left, and from the first frame on.
    for (const SolveMethod method : {SolveMethod::kVbd, SolveMethod::kXpbd}) {
        const VerificationScene scene = cantilever(method, 8, 2000);
        const SolveResult result = solve(scene);
        const auto [distance_m, moved_m] = distance(scene, result);
        EXPECT_TRUE(result.at_rest);
        EXPECT_LT(distance_m, 5e-3 * moved_m) << method_name(method);
        ASSERT_TRUE(result.equilibrium_error_m);
        // One Newton step is the distance to first order.
        EXPECT_NEAR(*result.equilibrium_error_m, distance_m, 0.02 * distance_m);
        EXPECT_FALSE(says(result, "from equilibrium"));
    }
}

TEST(RestWatch, WhatSetsOutSlowlyIsNotAtRest) {
    VerificationScene scene = cantilever(SolveMethod::kVbd, 4, 20);
    scene.rest_speed_m_s = 0.5;  // faster than it ever is
    const SolveResult result = solve(scene);
    const auto [distance_m, moved_m] = distance(scene, result);
    EXPECT_TRUE(result.at_rest);
    EXPECT_LT(distance_m, 5e-3 * moved_m);
    EXPECT_GT(result.simulated_s, 0.05);  // a quarter of its period
}

TEST(RestWatch, WhatSetsOutSlowlyOnASphereIsNotAtRest) {
    VerificationScene scene = cantilever(SolveMethod::kVbd, 4, 20);
    scene.rest_speed_m_s = 0.5;
    scene.spheres.push_back({Vec3(0.018, 0.005, -0.0052), 0.005, Vec3::Zero(), 0});
    const SolveResult result = solve(scene);
    EXPECT_TRUE(result.at_rest);
    EXPECT_GT(result.contact_force_n.norm(), 1e-4);  // it has come down on the sphere
    const auto [distance_m, moved_m] = distance(scene, result);
    EXPECT_LT(distance_m, 0.02 * moved_m);  // penalties of different stiffness
}

TEST(RestWatch, AMethodThatSettlesBesideTheEquilibriumSaysHowFar) {
    VerificationScene scene = cantilever(SolveMethod::kXpbdPair, 16, 30);
    scene.material.youngs_modulus_pa = 5e4;
    scene.rest_speed_m_s = 1e-5;
    const SolveResult result = solve(scene);
    const auto [distance_m, moved_m] = distance(scene, result);
    EXPECT_TRUE(result.at_rest);
    ASSERT_GT(distance_m, 0.02 * moved_m);  // or this method has become better
    ASSERT_TRUE(result.equilibrium_error_m);
    EXPECT_NEAR(*result.equilibrium_error_m, distance_m, 0.05 * distance_m);
    EXPECT_TRUE(says(result, "of the largest displacement) from equilibrium"));
    EXPECT_LT(result.simulated_s, 5);  // waiting does not help, and is given up
}

TEST(RestWatch, WhatIsNotAtRestInItsTimeSaysSo) {
    VerificationScene scene = cantilever(SolveMethod::kVbd, 4, 0.1);
    scene.end_s = 0.2;
    const SolveResult result = solve(scene);
    EXPECT_FALSE(result.at_rest);
    EXPECT_TRUE(says(result, "not at rest after 0.2 s"));
    EXPECT_TRUE(result.equilibrium_error_m);
}

}  // namespace THIS_TEST

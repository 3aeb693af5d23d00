// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/equilibrium.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace placode::sim;
using ::testing::HasSubstr;

namespace THIS_TEST {

/// Two cubes of 2 mm, the second 4 mm further along x.
VerificationScene two_cubes() {
    TetMesh mesh = box_mesh(Vec3(2e-3, 2e-3, 2e-3), {1, 1, 1});
    const TetMesh one = mesh;
    for (const Vec3& p : one.rest) mesh.rest.emplace_back(p + Vec3(4e-3, 0, 0));
    for (auto tet : one.tets) {
        for (int32_t& v : tet) v += 8;
        mesh.tets.push_back(tet);
        mesh.tissue.push_back(one.tissue[0]);
    }
    VerificationScene scene;
    std::vector<int32_t> same(mesh.rest.size());
    for (size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int32_t>(v);
    use_mesh(scene, mesh, mesh.rest, same);
    scene.solver.method = SolveMethod::kNewton;
    return scene;
}

HeldRegion floor_of(double low_x, double high_x) {
    return {{Vec3(low_x, 0, 0), Vec3(high_x, 1, 0)}, 7, Vec3::Zero(), 0, "/fixed/0"};
}

LoadRegion push(double x, double z, const Vec3& force_n) {
    return {{Vec3(x, 0, z), Vec3(x, 1, z)}, force_n, 0, "/loads/0"};
}

std::string refusal(const VerificationScene& scene) {
    try {
        (void)solve(scene);
    } catch (const VerificationError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Equilibrium, NamesThePieceThatNothingHolds) {
    VerificationScene scene = two_cubes();
    scene.held.push_back(floor_of(0, 2e-3));
    EXPECT_THAT(refusal(scene), HasSubstr("nothing holds the piece of 8 vertices around [0.005, "
                                          "0.001, 0.001] m, one of 2, along z"));
    scene.held.push_back(floor_of(4e-3, 6e-3));
    EXPECT_EQ(refusal(scene), "accepted");
}

TEST(Equilibrium, RefusesAFreeBodyThatLoadsTurn) {
    VerificationScene scene;
    use_box(scene, Vec3(2e-3, 2e-3, 2e-3), {1, 1, 1});
    scene.solver.method = SolveMethod::kNewton;
    scene.gravity_m_s2.setZero();
    scene.loads = {push(0, 0, Vec3(0, 0, 1e-5)), push(2e-3, 0, Vec3(0, 0, -1e-5))};
    EXPECT_THAT(refusal(scene), HasSubstr("loads turn it with 2e-08 N m"));
    // Pulled along their line the same forces are in balance.
    scene.loads = {push(0, 0, Vec3(-1e-5, 0, 0)), push(2e-3, 0, Vec3(1e-5, 0, 0))};
    EXPECT_EQ(refusal(scene), "accepted");
    scene.start = {StartKind::kRandom, 0.2, 1};
    EXPECT_EQ(refusal(scene), "accepted");
}

TEST(Equilibrium, TheWayThereIsTheDistanceToIt) {
    VerificationScene scene;
    use_box(scene, Vec3(4e-3, 2e-3, 2e-3), {4, 2, 2});
    scene.held.push_back({{Vec3(0, 0, 0), Vec3(0, 1, 1)}, 7, Vec3::Zero(), 0, "/fixed/0"});
    scene.solver.method = SolveMethod::kNewton;
    const SolveResult rest = solve(scene);
    const SolveSetup setup(scene, {});
    Coordinates there = setup.body->rest();
    for (size_t p = 0; p < rest.final_m.size(); ++p)
        there.segment<3>(3 * scene.vertex_of_output[p]) = rest.final_m[p];
    const Coordinates moved = there - setup.body->rest();
    const auto none = step_to_equilibrium(setup, there, 0);
    ASSERT_TRUE(none);
    EXPECT_LT(none->norm(), 1e-6 * moved.norm());
    // From 1 % before it; what is left of second order is 1e-4 of the strain of some per cent.
    const auto step = step_to_equilibrium(setup, there - 0.01 * moved, 0);
    ASSERT_TRUE(step);
    EXPECT_LT((*step - 0.01 * moved).norm(), 1e-3 * step->norm());
}

TEST(Equilibrium, SaysNothingAboutWhatNothingHolds) {
    VerificationScene scene = two_cubes();
    scene.held.push_back(floor_of(0, 2e-3));
    const SolveSetup setup(scene, {});
    EXPECT_FALSE(step_to_equilibrium(setup, setup.body->rest(), 0));
}

}  // namespace THIS_TEST

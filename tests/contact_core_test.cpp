// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One contact for what is felt and what is verified: a ball in a hand and the same ball as a body
// of a verification scene.

#include "sim/contact/contact_core.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/verify/verification_scene.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kRadius = 2.5e-3, kDiagonal = 0.02;
constexpr int kFrames = 80;

struct Found {
    Vec3 force_n = Vec3::Zero();  ///< On the ball, mean of the last frame.
    std::vector<Vec3> places;
};

/// The way of the ball: down into the tissue, or along it while it goes down.
struct Ball {
    Vec3 velocity_m_s = Vec3(0, 0, -6e-3);
    double friction = 0;
    Vec3 start = Vec3(1e-4, 2e-4, kRadius + 2e-5);  ///< Centre; the tissue's top is at z = 0.
};

/// A block whose diagonal is that of the bodies which verification gives to the kernels, so that
/// both sides compute in the same units.
test::BoxOptions block(const Ball& ball) {
    test::BoxOptions options;
    const double side = 0.012;
    options.size_m = Vec3(side, side, std::sqrt(kDiagonal * kDiagonal - 2 * side * side));
    options.cells = {12, 12, 9};
    options.material.youngs_modulus_pa = 20000;
    options.material.poissons_ratio = 0.4;
    options.material.density_kg_m3 = 1000;
    options.material.damping_per_s = 30;
    options.material.friction = ball.friction;
    options.material.friction_static_ratio = 1;
    options.material.fail_stretch = options.material.injury_stretch = 100;
    options.heat = options.sleep = false;
    options.tool.kind = ToolKind::kProbe;
    options.tool.tip_radius_m = options.tool.shaft_radius_m = kRadius;
    options.tool.hand_n_m = 1e12;  // its proxy is where it is put
    return options;
}

VerificationScene verification_of(const Scene& scene, const Ball& ball) {
    VerificationScene out;
    const TetMesh& mesh = scene.body.mesh();
    std::vector<int32_t> same(mesh.rest.size());
    for (size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int32_t>(v);
    use_mesh(out, mesh, mesh.rest, same);
    out.material = scene.body.spec().materials[0];
    out.gravity_m_s2.setZero();
    HeldRegion bottom;
    double low = 0;
    for (const Vec3& p : mesh.rest) low = std::min(low, p.z());
    bottom.box = {Vec3(-1, -1, low), Vec3(1, 1, low)};
    bottom.pointer = "/fixed/0";
    out.held.push_back(bottom);
    out.spheres.push_back({ball.start, kRadius, ball.velocity_m_s, ball.friction});
    out.solver.substeps = scene.body.spec().solver.substeps;
    out.solver.method = SolveMethod::kVbd;
    out.solver.threads = 1;
    out.solver.over_relaxation = 1;
    out.solver.single_precision = true;  // as the simulator
    out.solver.allow_invalid = true;
    out.end_s = kFrames * out.solver.frame_s;
    return out;
}

/// Contact as PressedVertices sets it: a margin and a stiffness that go by the mesh.
ContactSettings settings_of(const VerificationScene& scene) {
    const SphereContacts contacts(scene.mesh, scene.spheres);
    const double h = scene.solver.frame_s / scene.solver.substeps;
    ContactSettings out;
    out.stiffness_n_m = 300 * scene.material.youngs_modulus_pa * contacts.mean_edge_m();
    out.margin_m = 0.2 * contacts.mean_edge_m() + 2 * h * scene.spheres.front().velocity_m_s.norm();
    return out;
}

Found felt(const Scene& scene, const Ball& ball) {
    State state(scene, 1);
    ToolFeedback feedback;
    for (int i = 0; i <= kFrames; ++i) {
        const Vec3 centre = ball.start + 1e-3 * i * ball.velocity_m_s;
        test::frame(scene, state, test::upright(centre - Vec3(0, 0, kRadius)), feedback);
    }
    Found out{feedback.force_n, {}};
    for (int v = 0; v < scene.body.vertex_count(); ++v)
        out.places.push_back(position(state.body, v));
    return out;
}

void expect_the_same(const Ball& ball) {
    const test::BoxOptions options = block(ball);
    Scene scene = test::box_scene(options);
    const VerificationScene verified = verification_of(scene, ball);
    scene.contact = settings_of(verified);
    const Found tool = felt(scene, ball);
    const SolveResult sphere = solve(verified);
    ASSERT_GT(tool.force_n.z(), 0.01);
    double off = 0, moved = 0;
    for (size_t v = 0; v < tool.places.size(); ++v) {
        off = std::max(off, (tool.places[v] - sphere.final_m[v]).norm());
        moved = std::max(moved, (tool.places[v] - scene.body.mesh().rest[v]).norm());
    }
    EXPECT_GT(moved, 3e-4);
    // Vertices are visited in the order of a tree here and of the mesh there: 0.1 and 0.2 %.
    // Another law shows at once: without hardening the force is 6 % less, with two passes after the
    // sweep 18 %.
    EXPECT_LT((tool.force_n - sphere.contact_force_n).norm(), 3e-3 * tool.force_n.norm());
    EXPECT_LT(off, 5e-3 * moved);
}

TEST(ContactCore, ABallInAHandPressesAsTheSphereOfAVerificationScene) { expect_the_same({}); }

TEST(ContactCore, ABallInAHandRubsAsTheSphereOfAVerificationScene) {
    Ball ball;
    ball.friction = 0.3;
    ball.velocity_m_s = Vec3(9e-3, 0, -6e-3);
    expect_the_same(ball);
}

TEST(ContactCore, AFullListIsFullAndNothingIsWrittenBehindIt) {
    const Scene scene = test::box_scene(block({}));
    SoftBodyState body(scene.body);
    ContactLists lists(scene.body.vertex_count(), 2, 3);
    RigidSide side{0, 1e-3, 1, 0};
    NearTriangle near;
    near.vertex = {0, 1, 2};
    near.x = {Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0, 1e-3, 0)};
    // Each of its corners overlaps: three contacts, and there is room for two.
    for (size_t k = 0; k < 3; ++k) near.corner[k] = {-1e-4, -Vec3::UnitZ()};
    near.nearest.value_m = -1e-4;
    near.nearest.gradient = -Vec3::UnitZ();
    near.nearest.weight = Vec3::UnitX();
    EXPECT_FALSE(touch_triangle(lists, body, side, near));
    EXPECT_EQ(lists.contact_count, 2);
    EXPECT_LE(lists.feature_count, std::ssize(lists.feature_used));
}

}  // namespace THIS_TEST
}  // namespace placode::sim

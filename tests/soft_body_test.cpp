// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms and the checks of the constructor. Derivatives: vertex_system_test. Threads,
// recovery, contact: substep_test.
#include "sim/solver/soft_body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace placode::sim;
using ::testing::HasSubstr;

namespace THIS_TEST {

SoftBodySpec box_spec(const Vec3& size, const std::array<int, 3>& cells, Method method) {
    SoftBodySpec spec;
    const TetMesh box = box_mesh(size, cells, Tissue::kPlacode);
    spec.mesh = renumbered(box, rcm_order(box));
    spec.solver.method = method;
    spec.solver.gravity_m_s2.setZero();
    return spec;
}

Material& material(SoftBodySpec& spec) {
    return spec.materials[static_cast<size_t>(Tissue::kPlacode)];
}

Vec3 where(const SoftBodyState& state, int v) {
    const Float4& p = state.x[static_cast<size_t>(v)];
    return {p.x, p.y, p.z};
}

/// Springs that hold one coordinate of every vertex on a plane at rest.
void add_rollers(SoftBodySpec& spec, int axis, double coordinate, double moved_to,
                 double stiffness) {
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        Vec3 anchor = spec.mesh.rest[static_cast<size_t>(v)];
        if (std::abs(anchor[axis] - coordinate) > 1e-9) continue;
        anchor[axis] = moved_to;
        spec.springs.push_back({v, anchor, Vec3::Unit(axis), stiffness, 0.0});
    }
}

std::string refusal(SoftBodySpec spec) {
    try {
        const SoftBody body(std::move(spec));
    } catch (const MeshError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SoftBody, MassAndVolumeAddUp) {
    SoftBodySpec spec = box_spec(Vec3(4e-3, 2e-3, 2e-3), {4, 2, 2}, Method::kVbd);
    material(spec).density_kg_m3 = 1050;
    const SoftBody body(std::move(spec));
    double mass = 0, volume = 0;
    for (const float m : body.mass_kg()) mass += m;
    for (const float v : body.volume_m3()) volume += v;
    EXPECT_NEAR(volume, 16e-9, 16e-9 * 1e-6);
    EXPECT_NEAR(mass, 16e-9 * 1050, 16e-9 * 1050 * 1e-6);
    for (int v = 0; v < body.vertex_count(); ++v) {
        EXPECT_NEAR(body.shortest_edge_m()[static_cast<size_t>(v)], 1e-3, 1e-9);
    }
}

class EveryMethod : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         ::testing::Values(Method::kVbd, Method::kXpbd, Method::kXpbdPair));

TEST_P(EveryMethod, TheRestShapeIsStressFreeAndStill) {
    SoftBodySpec spec = box_spec(Vec3(3e-3, 3e-3, 3e-3), {3, 3, 3}, GetParam());
    spec.solver.substeps = 8;
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    // mu A of a face is 1.7 kPa x 1 mm^2 = 1.7 mN; floats leave 1e-6 of the terms that cancel.
    for (int v = 0; v < body.vertex_count(); ++v) {
        EXPECT_LT(elastic_force(body, state, v).norm(), 1e-8);
    }
    Workers workers(1);
    run_substeps(body, state, 4000, workers);
    if (GetParam() == Method::kXpbdPair) {
        // One projection after the other leaves the rest shape in between and comes back only
        // nearly: nothing holds this body, so it turns and drifts slowly. It must keep its shape
        // (measured here: .7 % shorter).
        for (const auto& tet : body.mesh().tets) {
            const double rest = (body.mesh().rest[static_cast<size_t>(tet[1])] -
                                 body.mesh().rest[static_cast<size_t>(tet[0])])
                                    .norm();
            EXPECT_NEAR((where(state, tet[1]) - where(state, tet[0])).norm(), rest, 1e-2 * rest);
        }
        return;
    }
    // Strain 1e-5 of a 1 mm edge is 10 nm: far below anything seen or felt.
    for (int v = 0; v < body.vertex_count(); ++v) {
        EXPECT_LT((where(state, v) - body.mesh().rest[static_cast<size_t>(v)]).norm(), 1e-8);
        const Float4& u = state.v[static_cast<size_t>(v)];
        EXPECT_LT(Vec3(u.x, u.y, u.z).norm(), 1e-5);
    }
    EXPECT_EQ(state.flags, 0u);
}

TEST_P(EveryMethod, AFreeBodyFallsWithGravity) {
    SoftBodySpec spec = box_spec(Vec3(2e-3, 2e-3, 2e-3), {2, 2, 2}, GetParam());
    spec.solver.gravity_m_s2 = Vec3(0, 0, -9.81);
    spec.solver.substeps = 8;
    material(spec).damping_per_s = 0;
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    for (const uint8_t free : state.free_vertex) EXPECT_EQ(free, 1);
    Workers workers(1);
    const int frames = 50;
    run_substeps(body, state, frames * 8, workers);
    const double time = frames * 1e-3, h = 1e-3 / 8;
    Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero();
    double mass = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const auto i = static_cast<size_t>(v);
        const double m = body.mass_kg()[i];
        centre += m * (where(state, v) - body.mesh().rest[i]);
        velocity += m * Vec3(state.v[i].x, state.v[i].y, state.v[i].z);
        mass += m;
    }
    centre /= mass;
    velocity /= mass;
    // First order in time: the exact sum is g t (t + h) / 2. Floats keep 2e-4 of it.
    EXPECT_NEAR(centre.z(), -9.81 * time * (time + h) / 2, 2e-4 * 9.81 * time * time / 2);
    EXPECT_NEAR(velocity.z(), -9.81 * time, 2e-4 * 9.81 * time);
    EXPECT_LT(std::hypot(centre.x(), centre.y()), 1e-6);
}

TEST(SoftBody, UniaxialStretchMeetsTheClosedForm) {
    // J = 1 + mu/lambda (1 - 1/a), b = sqrt(J / a), P = mu (a - J / a^2). VBD at Courant number 11.
    SoftBodySpec spec = box_spec(Vec3(2e-3, 2e-3, 2e-3), {2, 2, 2}, Method::kVbd);
    material(spec).youngs_modulus_pa = 50e3;
    material(spec).damping_per_s = 30;
    spec.solver.substeps = 1;
    const double a = 1.2, roller = 1e6;
    for (int axis = 0; axis < 3; ++axis) add_rollers(spec, axis, 0, 0, roller);
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        const Vec3& rest = spec.mesh.rest[static_cast<size_t>(v)];
        if (rest.x() < 2e-3 - 1e-9) continue;
        spec.springs.push_back({v, Vec3(a * 2e-3, rest.y(), rest.z()), Vec3::UnitX(), roller, 0.0});
    }
    const SoftBody body(std::move(spec));
    EXPECT_GT(body.courant_numbers()[static_cast<size_t>(Tissue::kPlacode)], 10);
    SoftBodyState state(body);
    Workers workers(1);
    run_substeps(body, state, 1500, workers);
    double pull = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Vec3& rest = body.mesh().rest[static_cast<size_t>(v)];
        const Vec3 now = where(state, v);
        // .1 %: linear tets reproduce homogeneous states exactly; the rollers give 1 nm/mN.
        EXPECT_NEAR(now.x(), a * rest.x(), 2e-3 * 1e-3);
        EXPECT_NEAR(now.y(), 0.920447 * rest.y(), 2e-3 * 1e-3);
        EXPECT_NEAR(now.z(), 0.920447 * rest.z(), 2e-3 * 1e-3);
        if (rest.x() > 2e-3 - 1e-9) pull -= elastic_force(body, state, v).x();
    }
    EXPECT_NEAR(pull / 4e-6, 8516.922, 8.5);
}

TEST(SoftBody, AHangingBarSagsByTheClosedForm) {
    // rho g L^2 / (2 E) at nu = 0, where linear tets have no lateral strain to lock. The lumped end
    // masses sum exactly to the continuous load at the nodes of a uniform mesh; second-order
    // strain terms are of the order of the strain, 1e-2.
    const double length = 20e-3, modulus = 20e3, density = 1000, g = 9.81;
    for (const Method method : {Method::kVbd, Method::kXpbd}) {
        SoftBodySpec spec = box_spec(Vec3(2e-3, 2e-3, length), {2, 2, 20}, method);
        material(spec) = {.youngs_modulus_pa = modulus,
                          .poissons_ratio = 0.0,
                          .density_kg_m3 = density,
                          .damping_per_s = 60};
        spec.solver.gravity_m_s2 = Vec3(0, 0, -g);
        spec.solver.substeps = method == Method::kVbd ? 4 : 24;
        for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
            if (spec.mesh.rest[static_cast<size_t>(v)].z() > length - 1e-9) spec.fixed.push_back(v);
        }
        const SoftBody body(std::move(spec));
        SoftBodyState state(body);
        EXPECT_EQ(state.free_vertex[0], 0);
        Workers workers(1);
        run_substeps(body, state, 500 * body.spec().solver.substeps, workers);
        double sag = 0;
        int tips = 0;
        for (int v = 0; v < body.vertex_count(); ++v) {
            const Vec3& rest = body.mesh().rest[static_cast<size_t>(v)];
            if (rest.z() > 1e-9) continue;
            sag += rest.z() - where(state, v).z();
            ++tips;
        }
        const double expected = density * g * length * length / (2 * modulus);
        const double tolerance = method == Method::kVbd ? 0.01 : 0.05;
        EXPECT_NEAR(sag / tips, expected, tolerance * expected);
    }
}

TEST(SoftBody, PreTensionPullsByTheClosedForm) {
    // Rest shape scaled by 1/a in the plane and held at its edges: equibiaxial stretch a; with free
    // faces c = (lambda + mu) a^2 / (mu + lambda a^4). Sides on rollers, thickness free.
    SoftBodySpec spec = box_spec(Vec3(2e-3, 2e-3, 1e-3), {2, 2, 1}, Method::kVbd);
    material(spec).youngs_modulus_pa = 200e3;
    const double a = 1.1;
    spec.rest_scale.assign(spec.mesh.tets.size(), {static_cast<float>(1 / a), 1.0F});
    for (const int axis : {0, 1}) {
        add_rollers(spec, axis, 0, 0, 1e5);
        add_rollers(spec, axis, 2e-3, 2e-3, 1e5);
    }
    add_rollers(spec, 2, 0, 0, 1e5);
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    Workers workers(1);
    run_substeps(body, state, 4000, workers);
    double pull = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Vec3& rest = body.mesh().rest[static_cast<size_t>(v)];
        if (rest.z() > 1e-9) {
            EXPECT_NEAR(where(state, v).z(), 0.850969e-3, 1e-6);
        }
        if (rest.x() > 2e-3 - 1e-9) pull -= elastic_force(body, state, v).x();
    }
    // Cauchy stress 32541.5 Pa on the deformed side, 2 mm x .850969 mm.
    EXPECT_NEAR(pull, 32541.5 * 2e-3 * 0.850969e-3, 1e-3 * 32541.5 * 1.7e-6);
}

TEST(SoftBody, XpbdAboveItsCourantLimitIsRefusedWithTheNumbers) {
    SoftBodySpec spec = box_spec(Vec3(2e-3, 2e-3, 2e-3), {2, 2, 2}, Method::kXpbd);
    // c_p = sqrt((lambda + mu) / rho) = 13.77 m/s, h = .25 ms, L = 1 mm: Co 3.44.
    material(spec).youngs_modulus_pa = 50e3;
    EXPECT_THAT(refusal(spec), HasSubstr("placode: Courant number 3.443 is above 1.1"));
    EXPECT_THAT(refusal(spec), HasSubstr("use vbd, or at least 13 substeps"));
    spec.solver.substeps = 13;
    EXPECT_EQ(refusal(spec), "accepted");
    EXPECT_THAT(SoftBody(spec).notes()[0], HasSubstr("inexact"));
    spec.solver.substeps = 40;
    EXPECT_THAT(SoftBody(spec).notes()[0], HasSubstr("xpbd: valid"));
    spec.solver.substeps = 4;
    spec.solver.allow_invalid = true;
    EXPECT_THAT(SoftBody(spec).notes()[0], HasSubstr("NOT VALID"));
    spec.solver.allow_invalid = false;
    spec.solver.method = Method::kVbd;
    EXPECT_THAT(SoftBody(spec).notes()[0], HasSubstr("placode: Courant number 3.443, vbd: valid"));
}

TEST(SoftBody, ABrokenSpecIsRefused) {
    const SoftBodySpec good = box_spec(Vec3(1e-3, 1e-3, 1e-3), {1, 1, 1}, Method::kVbd);
    EXPECT_EQ(refusal(good), "accepted");
    SoftBodySpec spec = good;
    material(spec).poissons_ratio = 0.5;
    EXPECT_THAT(refusal(spec), HasSubstr("placode: Poisson's ratio"));
    spec = good;
    spec.solver.over_relaxation = 1.6;
    EXPECT_THAT(refusal(spec), HasSubstr("over-relaxation"));
    spec = good;
    spec.fixed = {8};
    EXPECT_THAT(refusal(spec), HasSubstr("fixed: vertex 8"));
    spec = good;
    spec.rest_scale = {{1.0F, 1.0F}};
    EXPECT_THAT(refusal(spec), HasSubstr("rest_scale"));
    spec = good;
    spec.tethers.push_back({{1, 1}, 0, 1, 1});
    EXPECT_THAT(refusal(spec), HasSubstr("tether"));
}

}  // namespace THIS_TEST

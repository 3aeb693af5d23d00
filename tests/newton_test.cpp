// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is held against what needs no reference: closed forms of homogeneous states,
// finite differences, and the product's own vertex forces.
#include "sim/verify/newton.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "deformed.h"
#include "sim/verify/verification_scene.h"

using namespace placode::sim;

namespace THIS_TEST {

constexpr double kE = 50e3, kNu = 0.45, kEdge = 1e-3;

SoftBodySpec cube_spec(double nu = kNu) {
    SoftBodySpec spec;
    spec.mesh = box_mesh(Vec3(2e-3, 2e-3, 2e-3), {2, 2, 2});
    for (Material& m : spec.materials) {
        m.youngs_modulus_pa = kE;
        m.poissons_ratio = nu;
    }
    // A lattice without symmetry: homogeneous states must come out on any mesh.
    spec.mesh.rest[13] += Vec3(0.2e-3, -0.15e-3, 0.1e-3);
    return spec;
}

Coordinates deformed(const ReferenceBody& body, const Mat3& f, double noise = 0) {
    return test::deformed(body.rest(), f, noise, 7);
}

/// Equilibrium with the normal coordinate of the planes x_a = 0 held, and of x = 2 mm moved.
struct Uniaxial {
    double stretch = 1.2, nu = kNu;
    Coordinates x;
    double force_n = 0;
    NewtonReport report;

    void solve() {
        const ReferenceBody body(cube_spec(nu));
        StaticProblem problem;
        problem.body = &body;
        const Eigen::Index n = body.rest().size();
        problem.held.assign(static_cast<size_t>(n), 0);
        problem.held_at = body.rest();
        problem.force_n = Coordinates::Zero(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double rest = body.rest()[i];
            if (rest == 0) problem.held[static_cast<size_t>(i)] = 1;
            if (i % 3 == 0 && rest > 2e-3 - 1e-9) {
                problem.held[static_cast<size_t>(i)] = 1;
                problem.held_at[i] = stretch * rest;
            }
        }
        x = body.rest();
        NewtonSettings settings;
        settings.tolerance = 1e-12;
        report = solve_static(problem, x, settings);
        Coordinates gradient = Coordinates::Zero(n);
        body.add_gradient(x, gradient);
        for (Eigen::Index i = 0; i < n; i += 3) {
            if (body.rest()[i] > 2e-3 - 1e-9) force_n += gradient[i];
        }
    }
};

TEST(Newton, GradientIsTheDerivativeOfTheEnergy) {
    SoftBodySpec spec = cube_spec();
    spec.springs.push_back({3, Vec3(1e-4, 0, 0), Vec3(1, 2, 3), 50, 20});
    spec.rest_scale.assign(spec.mesh.tets.size(), {0.93F, 1.05F});
    const ReferenceBody body(spec);
    Mat3 f;
    f << 1.2, 0.1, 0, -0.2, 0.9, 0.1, 0.05, 0, 1.1;
    Coordinates x = deformed(body, f, 0.3e-3);
    Coordinates gradient = Coordinates::Zero(x.size());
    body.add_gradient(x, gradient);
    const double d = 1e-8;  // of 1 mm edges: truncation 1e-10, rounding 1e-16 E / (f d) = 1e-9
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Coordinates plus = x, minus = x;
        plus[i] += d;
        minus[i] -= d;
        const double slope = (body.energy(plus) - body.energy(minus)) / (2 * d);
        EXPECT_NEAR(gradient[i], slope, 1e-6 * gradient.lpNorm<Eigen::Infinity>()) << i;
    }
}

TEST(Newton, TangentIsTheDerivativeOfTheGradient) {
    SoftBodySpec spec = cube_spec();
    spec.springs.push_back({3, Vec3(1e-4, 0, 0), Vec3(1, 2, 3), 50, 20});
    const ReferenceBody body(spec);
    Mat3 f;
    f << 1.2, 0.1, 0, -0.2, 0.9, 0.1, 0.05, 0, 1.1;
    // Strongly disturbed: some tets are inverted, the tangent must hold there as well.
    Coordinates x = deformed(body, f, 1.6e-3);
    EXPECT_GT(body.inverted_tets(x), 0);
    Triplets triplets;
    body.add_stiffness(x, false, triplets);
    SparseMatrix k(x.size(), x.size());
    k.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::MatrixXd dense(k);
    EXPECT_LT((dense - dense.transpose()).norm(), 1e-12 * dense.norm());
    const double d = 1e-8;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Coordinates plus = x, minus = x, up = Coordinates::Zero(x.size()), down = up;
        plus[i] += d;
        minus[i] -= d;
        body.add_gradient(plus, up);
        body.add_gradient(minus, down);
        const Coordinates column = (up - down) / (2 * d);
        EXPECT_LT((dense.col(i) - column).norm(), 1e-6 * dense.norm()) << i;
    }
}

TEST(Newton, ProjectedTangentIsPositiveSemidefinite) {
    const ReferenceBody body(cube_spec());
    const Coordinates x = deformed(body, 0.5 * Mat3::Identity(), 1.6e-3);
    for (const bool projected : {false, true}) {
        Triplets triplets;
        body.add_stiffness(x, projected, triplets);
        SparseMatrix k(x.size(), x.size());
        k.setFromTriplets(triplets.begin(), triplets.end());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen((Eigen::MatrixXd(k)));
        const double least = eigen.eigenvalues()[0], most = eigen.eigenvalues().tail<1>()[0];
        if (projected) {
            EXPECT_GT(least, -1e-12 * most);
        } else {
            EXPECT_LT(least, -1e-3 * most) << "this state shows nothing";
        }
    }
}

TEST(Newton, ForcesAreThoseOfTheProductsSolver) {
    SoftBodySpec spec = cube_spec();
    spec.rest_scale.assign(spec.mesh.tets.size(), {0.93F, 1.05F});
    const ReferenceBody reference(spec);
    const SoftBody body(spec);
    SoftBodyState state(body);
    Mat3 f;
    f << 1.2, 0.1, 0, -0.2, 0.9, 0.1, 0.05, 0, 1.1;
    Coordinates x = deformed(reference, f, 0.3e-3);
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Vec3f p = x.segment<3>(3 * v).cast<float>();
        state.x[static_cast<size_t>(v)] = {p.x(), p.y(), p.z(), 1};
        x.segment<3>(3 * v) = p.cast<double>();
    }
    Coordinates gradient = Coordinates::Zero(x.size());
    reference.add_gradient(x, gradient);
    for (int v = 0; v < body.vertex_count(); ++v) {
        // The solver's constants are floats: 1e-6 of the terms that cancel, mu times the edge.
        EXPECT_LT((elastic_force(body, state, v) + Vec3(gradient.segment<3>(3 * v))).norm(),
                  2e-6 * kE * kEdge * kEdge);
    }
}

TEST(Newton, UniaxialStretchMeetsTheClosedForm) {
    // J = 1 + mu/lambda (1 - 1/a), b = sqrt(J/a), P = mu (a - J/a^2).
    for (const double nu : {0.40, 0.45, 0.49}) {
        const NeoHookean c = neo_hookean(kE, nu);
        for (const double a : {0.6, 0.8, 1.05, 1.2, 1.5, 2.0}) {
            Uniaxial state{a, nu, {}, 0, {}};
            state.solve();
            ASSERT_TRUE(state.report.converged) << a;
            const double j = 1 + c.mu_pa / c.lambda_pa * (1 - 1 / a), b = std::sqrt(j / a);
            const double p = c.mu_pa * (a - j / (a * a));
            EXPECT_NEAR(state.force_n / 4e-6, p, 1e-6 * std::abs(p)) << "a " << a << " nu " << nu;
            const ReferenceBody body(cube_spec(nu));
            for (Eigen::Index i = 0; i < state.x.size(); ++i) {
                const double scale = i % 3 == 0 ? a : b;
                EXPECT_NEAR(state.x[i], scale * body.rest()[i], 1e-6 * 2e-3);
            }
        }
    }
}

TEST(Newton, UniaxialTableOfTheClinicalReference) {
    // E 50 kPa, nu .45: P of the published table, to its last digit.
    for (const auto& [a, p] : {std::pair{0.8, -12473.060}, {1.1, 4586.906}, {1.5, 17943.806}}) {
        Uniaxial state{a, 0.45, {}, 0, {}};
        state.solve();
        EXPECT_NEAR(state.force_n / 4e-6, p, 0.002);
    }
}

TEST(Newton, ShearHydrostaticAndConfinedStressesMeetTheClosedForms) {
    // The boundary is held in F X; the inner vertex must find F X and the faces carry P N.
    const NeoHookean c = neo_hookean(kE, kNu);
    struct Case {
        Mat3 f;
        Mat3 p;  // first Piola stress
    };
    std::vector<Case> cases;
    const double k = 0.5, a = 0.8;
    Mat3 shear = Mat3::Identity(), p = Mat3::Zero();
    shear(0, 1) = k;
    p(0, 1) = p(1, 0) = c.mu_pa * k;  // sigma_12 = mu k, sigma_11 = mu k^2, P = sigma F^-T
    cases.push_back({shear, p});
    const double pressure = c.mu_pa / a + c.lambda_pa * (a * a * a - 1) - c.mu_pa;
    cases.push_back({a * Mat3::Identity(), pressure * a * a * Mat3::Identity()});
    const double side = c.mu_pa + c.lambda_pa * (a - 1) * a - c.mu_pa * a;
    cases.push_back({Vec3(a, 1, 1).asDiagonal(),
                     Vec3((c.lambda_pa + c.mu_pa) * (a - 1), side, side).asDiagonal()});
    for (const Case& one : cases) {
        const ReferenceBody body(cube_spec());
        StaticProblem problem;
        problem.body = &body;
        const Eigen::Index n = body.rest().size();
        problem.held.assign(static_cast<size_t>(n), 1);
        for (int axis = 0; axis < 3; ++axis) problem.held[3 * 13 + static_cast<size_t>(axis)] = 0;
        problem.held_at = deformed(body, one.f);
        problem.force_n = Coordinates::Zero(n);
        Coordinates x = body.rest();
        const NewtonReport report = solve_static(problem, x);
        ASSERT_TRUE(report.converged);
        EXPECT_LT((x - problem.held_at).lpNorm<Eigen::Infinity>(), 1e-6 * kEdge);
        // Mean stress = 1/V sum f X^T over the boundary.
        Coordinates gradient = Coordinates::Zero(n);
        body.add_gradient(x, gradient);
        Mat3 mean = Mat3::Zero();
        for (Eigen::Index i = 0; i < n; i += 3)
            mean += gradient.segment<3>(i) * body.rest().segment<3>(i).transpose() / 8e-9;
        EXPECT_LT((mean - one.p).norm(), 1e-6 * one.p.norm()) << mean << "\n" << one.p;
    }
}

TEST(Newton, FindsTheSameStateFromRandomFlatAndMirroredStarts) {
    VerificationScene scene;
    use_box(scene, Vec3(3e-3, 2e-3, 2e-3), {3, 2, 2});
    scene.material.youngs_modulus_pa = 5e3;
    scene.solver.method = SolveMethod::kNewton;
    scene.held.push_back({{Vec3(0, 0, 0), Vec3(0, 1, 1)}, 7, Vec3::Zero(), 0, "/fixed/0"});
    const SolveResult expected = solve(scene);
    ASSERT_FALSE(expected.diverged);
    for (const StartKind kind : {StartKind::kRandom, StartKind::kFlat, StartKind::kMirror,
                                 StartKind::kStretch, StartKind::kPoint}) {
        // Fully random starts have other equilibria (twisted by a whole turn): 0.3 has not.
        const double amount = kind == StartKind::kStretch  ? 0.5
                              : kind == StartKind::kRandom ? 0.3
                                                           : 1.0;
        scene.start = {kind, amount, 3};
        const SolveResult found = solve(scene);
        ASSERT_FALSE(found.diverged) << static_cast<int>(kind);
        EXPECT_EQ(found.inverted_tets, 0);
        for (size_t i = 0; i < found.final_m.size(); ++i)
            ASSERT_LT((found.final_m[i] - expected.final_m[i]).norm(), 1e-9)
                << static_cast<int>(kind);
    }
}

TEST(Newton, RefusesABodyThatNothingHolds) {
    VerificationScene scene;
    use_box(scene, Vec3(1e-3, 1e-3, 1e-3), {1, 1, 1});
    scene.solver.method = SolveMethod::kNewton;
    EXPECT_THROW((void)solve(scene), VerificationError);
    scene.gravity_m_s2.setZero();
    EXPECT_FALSE(solve(scene).diverged);  // at rest: nothing to do
}

}  // namespace THIS_TEST

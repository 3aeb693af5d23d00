// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles against what needs no triangles: the three-dimensional energy with its thickness left
// free, and derivatives by finite differences. What a sheet comes to rest at: sheet_statics_test.
#include "sim/solver/sheet.h"
#include "sim/core/as_index.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "deformed.h"
#include "sheet_specs.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/verify/newton.h"

using namespace placode::sim;
using namespace placode::sim::test;

namespace THIS_TEST {

Coordinates disturbed(const Coordinates& rest, const Mat3& f, double noise) {
    return deformed(rest, f, noise, 11);
}

void put(SoftBodyState& state, Coordinates& x) {
    for (size_t v = 0; v < state.x.size(); ++v) {
        const auto i = static_cast<Eigen::Index>(3 * v);
        const Vec3f p = x.segment<3>(i).cast<float>();
        state.x[v] = {p.x(), p.y(), p.z(), state.x[v].w};
        x.segment<3>(i) = p.cast<double>();
    }
}

/// Energy density of a membrane of two principal stretches: the energy of a solid with its third
/// stretch where that costs least, found by bisection of the slope.
double solid_density(const NeoHookean& c, double a, double b) {
    double low = 1e-3, high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double t = (low + high) / 2;
        const double slope = c.lambda_pa * (a * b * t - c.gamma) * a * b + c.mu_pa * t;
        (slope < 0 ? low : high) = t;
    }
    const double t = low, j = a * b * t - c.gamma;
    return c.lambda_pa / 2 * (j * j - (1 - c.gamma) * (1 - c.gamma)) +
           c.mu_pa / 2 * (a * a + b * b + t * t - 3);
}

TEST(Sheet, HasTheEnergyOfASolidWhoseThicknessIsFree) {
    SoftBodySpec spec = grid(3, 2, 1e-3);
    spec.sheet_bending = 0;
    const ReferenceBody body(spec);
    const NeoHookean c = neo_hookean(kE, kNu);
    for (const auto& [a, b] : {std::pair{1.0, 1.0}, {1.3, 1.1}, {0.7, 0.9}, {2.0, 0.5}}) {
        Mat3 f = Mat3::Zero();
        f.diagonal() << a, b, 1;
        const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
        const Coordinates x = disturbed(body.rest(), turn.toRotationMatrix() * f, 0);
        const double volume = 3e-3 * 2e-3 * kThickness;
        // Bisection leaves 1e-16 of the terms, which are of the size of E.
        EXPECT_NEAR(body.energy(x), volume * solid_density(c, a, b), 1e-12 * volume * kE) << a;
    }
}

TEST(Sheet, GradientAndTangentOfTheReferenceAreDerivatives) {
    for (const double share : {0.0, 1.0}) {
        SoftBodySpec spec = grid(3, 3, 1e-3);
        for (Vec3& p : spec.mesh.rest) p.z() = 40 * p.x() * p.x() - 30 * p.x() * p.y();  // curved
        for (SheetTriangle& t : spec.sheet) t.thickness_m = 0.5e-3;  // so that bending counts
        spec.sheet_bending = share;
        const ReferenceBody body(spec);
        Mat3 f;
        f << 1.2, 0.1, 0, -0.2, 0.9, 0.1, 0.05, 0, 1.1;
        Coordinates x = disturbed(body.rest(), f, 0.4e-3);
        Coordinates gradient = Coordinates::Zero(x.size());
        body.add_gradient(x, gradient);
        Triplets triplets;
        body.add_stiffness(x, false, triplets);
        SparseMatrix k(x.size(), x.size());
        k.setFromTriplets(triplets.begin(), triplets.end());
        const Eigen::MatrixXd dense(k);
        EXPECT_LT((dense - dense.transpose()).norm(), 1e-12 * dense.norm());
        const double d = 1e-8;  // of 1 mm edges, as in newton_test
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            Coordinates plus = x, minus = x, up = Coordinates::Zero(x.size()), down = up;
            plus[i] += d;
            minus[i] -= d;
            const double slope = (body.energy(plus) - body.energy(minus)) / (2 * d);
            EXPECT_NEAR(gradient[i], slope, 1e-6 * gradient.lpNorm<Eigen::Infinity>()) << i;
            body.add_gradient(plus, up);
            body.add_gradient(minus, down);
            EXPECT_LT((dense.col(i) - (up - down) / (2 * d)).norm(), 1e-6 * dense.norm()) << i;
        }
    }
}

TEST(Sheet, VertexGradientIsThatOfTheReferenceAndItsHessianIsPositive) {
    SoftBodySpec spec = flap_spec();
    for (SheetTriangle& t : spec.sheet) t.thickness_m = 0.5e-3;
    const ReferenceBody reference(spec);
    const SoftBody body(spec);
    SoftBodyState state(body);
    for (const double noise : {0.1e-3, 1.5e-3}) {  // the second folds and crushes triangles
        Coordinates x = disturbed(reference.rest(), 1.05 * Mat3::Identity(), noise);
        put(state, x);
        state.x_start = state.x;
        Coordinates gradient = Coordinates::Zero(x.size());
        reference.add_gradient(x, gradient);
        const double scale = reference.largest_term_n() * (1 + noise / 1e-3 * 10);
        for (int v = 0; v < body.vertex_count(); ++v) {
            // Constants of tets are floats: 1e-6 of the terms that cancel.
            EXPECT_LT((elastic_force(body, state, v) + Vec3(gradient.segment<3>(3 * v))).norm(),
                      2e-6 * scale)
                << v;
            const Mat3 h = vertex_system(body, state, v, 2.5e-4).hessian;
            EXPECT_GT(h.selfadjointView<Eigen::Lower>().eigenvalues()[0], 0.0) << v;
        }
    }
}

TEST(Sheet, VertexHessianOfAStretchedMembraneIsExact) {
    SoftBodySpec spec = grid(3, 3, 1e-3);
    spec.sheet_bending = 0;
    const ReferenceBody reference(spec);
    const SoftBody body(spec);
    SoftBodyState state(body);
    Mat3 f = Mat3::Zero();
    f.diagonal() << 1.3, 1.2, 1;
    Coordinates x = disturbed(reference.rest(), f, 0.05e-3);
    put(state, x);
    Triplets triplets;
    reference.add_stiffness(x, false, triplets);
    SparseMatrix k(x.size(), x.size());
    k.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::MatrixXd dense(k);
    const double h = 1e3;  // s: no inertia
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Mat3 exact = dense.block<3, 3>(3 * v, 3 * v);
        EXPECT_LT((vertex_system(body, state, v, h).hessian - exact).norm(), 1e-9 * exact.norm());
    }
}

TEST(Sheet, TurningTheBodyTurnsItsForces) {
    SoftBodySpec spec = grid(4, 3, 1e-3);
    for (Vec3& p : spec.mesh.rest) p.z() = 50 * p.x() * p.x();
    const ReferenceBody body(spec);
    const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(3, -1, 2).normalized()).toRotationMatrix();
    const Coordinates x = disturbed(body.rest(), Mat3::Identity(), 0.3e-3);
    Coordinates y = x, gx = Coordinates::Zero(x.size()), gy = gx;
    for (Eigen::Index i = 0; i < x.size(); i += 3)
        y.segment<3>(i) = turn * x.segment<3>(i) + Vec3(1e-3, 2e-3, -5e-3);
    body.add_gradient(x, gx);
    body.add_gradient(y, gy);
    EXPECT_NEAR(body.energy(y), body.energy(x), 1e-12 * body.energy(x));
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
        EXPECT_LT((gy.segment<3>(i) - turn * gx.segment<3>(i)).norm(), 1e-11 * gx.norm());
        sum += gx.segment<3>(i);
        moment += Vec3(x.segment<3>(i)).cross(Vec3(gx.segment<3>(i)));
    }
    EXPECT_LT(sum.norm(), 1e-12 * gx.norm());
    EXPECT_LT(moment.norm(), 1e-12 * gx.norm() * 4e-3);
    Coordinates at_rest = Coordinates::Zero(x.size());
    body.add_gradient(body.rest(), at_rest);
    EXPECT_LT(at_rest.norm(), 1e-13 * body.largest_term_n() * static_cast<double>(x.size()));
}

TEST(Sheet, TheSameBitsOnOneToFourThreads) {
    const SoftBody body(flap_spec());
    uint64_t first = 0;
    for (const int threads : {1, 2, 3, 4}) {
        SoftBodyState state(body);
        Workers workers(threads);
        run_substeps(body, state, 200, workers);
        if (threads == 1) first = state_hash(state);
        EXPECT_EQ(state_hash(state), first) << threads;
    }
}

TEST(Sheet, ABodyWithoutTrianglesPaysNothing) {
    SoftBodySpec spec = flap_spec();
    spec.mesh = box_mesh(Vec3(4e-3, 4e-3, 2e-3), {4, 4, 2});
    spec.sheet.clear();
    const SoftBody body(spec);
    EXPECT_TRUE(body.packed().single_vertices.empty());
    EXPECT_TRUE(body.packed().sheet.triangles.empty());
    EXPECT_TRUE(body.packed().sheet.start.empty());
    EXPECT_TRUE(body.packed().sheet.around(3).empty());
}

TEST(Sheet, ASheetShrunkToAPointIsGivenItsRestShape) {
    const SoftBody body(grid(3, 3, 1e-3));
    SoftBodyState state(body);
    for (Float4& p : state.x) p = {1e-3F, 1e-3F, 0, p.w};
    EXPECT_EQ(restore_collapsed(body, state), body.vertex_count());
    for (int v = 1; v < body.vertex_count(); ++v) {
        const Float4 &p = state.x[as_index(v)], &q = state.x[0];
        const Vec3 rest = body.mesh().rest[as_index(v)] - body.mesh().rest[0];
        EXPECT_LT((Vec3(p.x - q.x, p.y - q.y, p.z - q.z) - rest).norm(), 1e-9);
    }
}

TEST(Sheet, ABrokenSheetIsRefusedByTheNumberOfItsTriangle) {
    const auto refused = [](const std::function<void(SoftBodySpec&)>& spoil,
                            const std::string& expected) {
        SoftBodySpec spec = flap_spec();
        spoil(spec);
        try {
            const SoftBody body(spec);
            ADD_FAILURE() << "not refused: " << expected;
        } catch (const MeshError& error) {
            EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
        }
    };
    refused([](SoftBodySpec& s) { s.sheet[7].vertex[1] = s.sheet[7].vertex[0]; },
            "sheet triangle 7: vertex ");
    refused([](SoftBodySpec& s) { s.sheet[3].vertex[2] = 9999; },
            "sheet triangle 3: vertex 9999 is outside 0 .. ");
    refused([](SoftBodySpec& s) { s.sheet[5].thickness_m = 0; }, "sheet triangle 5: thickness 0 m");
    refused([](SoftBodySpec& s) { s.sheet.push_back(s.sheet[2]); }, "duplicate of triangle 2");
    refused(
        [](SoftBodySpec& s) {
            const auto& t = s.sheet[4].vertex;
            s.mesh.rest[as_index(t[2])] =
                (s.mesh.rest[as_index(t[0])] + s.mesh.rest[as_index(t[1])]) / 2;
        },
        "is degenerate, must be above 1e-6 of the squared longest edge");
    refused(
        [](SoftBodySpec& s) {
            const auto t = s.sheet[6].vertex;  // the list moves as it grows
            s.sheet.push_back({{t[0], t[1], 0}, Tissue::kSkin, kThickness});
            s.sheet.push_back({{t[0], t[1], 1}, Tissue::kSkin, kThickness});
        },
        "has more than two triangles");
    refused([](SoftBodySpec& s) { s.solver.method = Method::kXpbd; },
            "method xpbd knows tetrahedra only; use vbd");
    refused([](SoftBodySpec& s) { s.sheet_bending = 2; }, "bending 2, allowed 0 to 1");
    refused([](SoftBodySpec& s) { s.materials[0].poissons_ratio = 0.5; }, "Poisson's ratio");
}

}  // namespace THIS_TEST

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles against what needs no triangles: the three-dimensional energy with its thickness left
// free, closed forms of homogeneous states, plate theory, and double-precision equilibria.
#include "sim/solver/sheet.h"
#include "sim/core/as_index.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "deformed.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/verify/newton.h"

using namespace placode::sim;

namespace THIS_TEST {

constexpr double kE = 200e3, kNu = 0.45, kThickness = 0.1e-3;

enum class Diagonal { kRising, kFalling, kCrossed };

/// nx x ny squares of `edge`, each of two triangles (kCrossed alternates their diagonal).
void add_grid(SoftBodySpec& spec, int nx, int ny, double edge, Diagonal diagonal,
              const Vec3& origin = Vec3::Zero()) {
    const auto first = static_cast<int32_t>(spec.mesh.rest.size());
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) spec.mesh.rest.push_back(origin + edge * Vec3(i, j, 0));
    }
    const auto vertex = [&](int i, int j) { return first + j * (nx + 1) + i; };
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
            const bool rising = diagonal == Diagonal::kRising ||
                                (diagonal == Diagonal::kCrossed && (i + j) % 2 == 0);
            if (rising) {
                spec.sheet.push_back({{a, b, c}, Tissue::kSkin, kThickness});
                spec.sheet.push_back({{a, c, d}, Tissue::kSkin, kThickness});
            } else {
                spec.sheet.push_back({{a, b, d}, Tissue::kSkin, kThickness});
                spec.sheet.push_back({{b, c, d}, Tissue::kSkin, kThickness});
            }
        }
    }
}

SoftBodySpec grid(int nx, int ny, double edge, Diagonal diagonal = Diagonal::kCrossed,
                  double nu = kNu) {
    SoftBodySpec spec;
    for (Material& m : spec.materials) {
        m.youngs_modulus_pa = kE;
        m.poissons_ratio = nu;
        m.density_kg_m3 = 1000;
        m.damping_per_s = 0;
    }
    add_grid(spec, nx, ny, edge, diagonal);
    return spec;
}

/// A block of tets, 4 x 4 x 2 mm, with a sheet welded along x = 4 mm, y = 0 .. 4 mm at half height
/// and reaching 4 mm beyond.
SoftBodySpec flap_spec(Method method = Method::kVbd) {
    SoftBodySpec spec = grid(0, 0, 1);
    spec.mesh = box_mesh(Vec3(4e-3, 4e-3, 2e-3), {4, 4, 2});
    for (Material& m : spec.materials) m.damping_per_s = 40;
    Material& soft = spec.materials[static_cast<size_t>(Tissue::kSubcutis)];
    soft.youngs_modulus_pa = 20e3;
    const auto tets_have = static_cast<int32_t>(spec.mesh.rest.size());
    add_grid(spec, 4, 4, 1e-3, Diagonal::kCrossed, Vec3(4e-3, 0, 1e-3));
    for (SheetTriangle& t : spec.sheet) {
        for (int32_t& v : t.vertex) {  // weld: the same place is the same vertex
            for (int32_t w = 0; w < tets_have; ++w) {
                if ((spec.mesh.rest[as_index(v)] - spec.mesh.rest[as_index(w)]).norm() < 1e-9)
                    v = w;
            }
        }
    }
    // Points that were welded away are left out.
    std::vector<int32_t> number(spec.mesh.rest.size(), -1);
    std::vector<Vec3> rest(spec.mesh.rest.begin(), spec.mesh.rest.begin() + tets_have);
    for (int32_t v = 0; v < tets_have; ++v) number[as_index(v)] = v;
    for (SheetTriangle& t : spec.sheet) {
        for (int32_t& v : t.vertex) {
            if (number[as_index(v)] < 0) {
                number[as_index(v)] = static_cast<int32_t>(rest.size());
                rest.push_back(spec.mesh.rest[as_index(v)]);
            }
            v = number[as_index(v)];
        }
    }
    spec.mesh.rest = rest;
    for (int32_t v = 0; v < tets_have; ++v) {
        if (rest[as_index(v)].x() == 0) spec.fixed.push_back(v);
    }
    spec.solver.method = method;
    return spec;
}

Coordinates disturbed(const Coordinates& rest, const Mat3& f, double noise) {
    return test::deformed(rest, f, noise, 11);
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

StaticProblem hold(const ReferenceBody& body, const std::function<uint8_t(const Vec3&)>& axes) {
    StaticProblem problem;
    problem.body = &body;
    problem.held.assign(as_index(body.rest().size()), 0);
    problem.held_at = body.rest();
    problem.force_n = Coordinates::Zero(body.rest().size());
    for (int v = 0; v < body.vertex_count(); ++v) {
        const uint8_t bits = axes(body.rest().segment<3>(3 * v));
        for (int a = 0; a < 3; ++a) problem.held[as_index(3 * v + a)] = bits >> a & 1;
    }
    return problem;
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

TEST(Sheet, UniaxialAndBiaxialStretchMeetTheClosedForms) {
    // Clinical reference 7.1 (free sides) and 7.5 (equibiaxial): first Piola stress x t x width.
    const NeoHookean c = neo_hookean(kE, kNu);
    SoftBodySpec spec = grid(6, 4, 1e-3);
    spec.mesh.rest[16] += Vec3(0.2e-3, -0.1e-3, 0);  // homogeneous states come out on any mesh
    const ReferenceBody body(spec);
    const double length = 6e-3, width = 4e-3;
    for (const double a : {0.9, 1.05, 1.2, 1.5}) {
        for (const bool biaxial : {false, true}) {
            StaticProblem problem = hold(body, [&](const Vec3& p) {
                int bits = 4;  // in its plane: no buckling
                if (p.x() < 1e-9 || p.x() > length - 1e-9) bits |= 1;
                if (p.y() < 1e-9 || (biaxial && p.y() > width - 1e-9)) bits |= 2;
                return static_cast<uint8_t>(bits);
            });
            for (int v = 0; v < body.vertex_count(); ++v) {
                const Vec3 p = body.rest().segment<3>(3 * v);
                if (p.x() > length - 1e-9) problem.held_at[3 * v] = a * length;
                if (biaxial && p.y() > width - 1e-9) problem.held_at[3 * v + 1] = a * width;
            }
            Coordinates x = body.rest(), gradient = Coordinates::Zero(x.size());
            ASSERT_TRUE(solve_static(problem, x, {1e-12, 100, 4}).converged) << a;
            body.add_gradient(x, gradient);
            double force = 0;
            for (int v = 0; v < body.vertex_count(); ++v) {
                if (body.rest()[3 * v] > length - 1e-9) force += gradient[3 * v];
            }
            double expected = 0;
            if (biaxial) {
                const double s = (c.lambda_pa + c.mu_pa) * a * a /
                                 (c.mu_pa + c.lambda_pa * a * a * a * a);  // stretch of thickness
                expected = c.mu_pa * (a * a - s * s) / (a * a * s) * (a * s);  // sigma J / a
            } else {
                const double j = 1 + c.mu_pa / c.lambda_pa * (1 - 1 / a);
                expected = c.mu_pa * (a - j / (a * a));
            }
            EXPECT_NEAR(force, expected * kThickness * width, 1e-6 * std::abs(force))
                << a << " biaxial " << biaxial;
        }
    }
}

TEST(Sheet, AClampedStripBendsAsBeamTheorySays) {
    // Two columns of vertices are held, so that the clamp stands in the middle of them; a force at
    // the end, delta = F L^3 / (3 E I), small enough to be linear. nu 0 and 0.3, all diagonals.
    const double edge = 1e-3, width = 2e-3, length = 20e-3 - edge / 2;
    for (const double nu : {0.0, 0.3}) {
        for (const Diagonal d : {Diagonal::kRising, Diagonal::kFalling, Diagonal::kCrossed}) {
            const SoftBodySpec spec = grid(20, 2, edge, d, nu);
            const ReferenceBody body(spec);
            StaticProblem problem = hold(body, [&](const Vec3& p) {
                return static_cast<uint8_t>(p.x() < edge + 1e-9 ? 7 : 0);
            });
            const double force = 1e-9;
            int tip = 0;
            double moved = 0;
            for (int v = 0; v < body.vertex_count(); ++v) {
                if (body.rest()[3 * v] > 20e-3 - 1e-9) ++tip;
            }
            for (int v = 0; v < body.vertex_count(); ++v) {
                if (body.rest()[3 * v] > 20e-3 - 1e-9) problem.force_n[3 * v + 2] = force / tip;
            }
            Coordinates x = body.rest();
            ASSERT_TRUE(solve_static(problem, x, {1e-9, 100, 1}).converged);
            for (int v = 0; v < body.vertex_count(); ++v) {
                if (body.rest()[3 * v] > 20e-3 - 1e-9) moved += x[3 * v + 2] / tip;
            }
            const double inertia = width * std::pow(kThickness, 3) / 12;
            const double beam = force * std::pow(length, 3) / (3 * kE * inertia);
            // The clamp keeps a strip of nu 0.3 from curling over a width of its length: 1 %.
            EXPECT_NEAR(moved / beam, 1, 0.02)
                << "nu " << nu << " diagonal " << static_cast<int>(d);
        }
    }
}

TEST(Sheet, ASimplySupportedPlateSagsAsPlateTheorySays) {
    // Timoshenko: centre 0.00406 q a^4 / D under a uniform load, square, edges held in z only, and
    // nu 0.3. The load is small: in the plane nothing happens.
    const int cells = 12;
    const double edge = 1e-3, side = cells * edge, pressure = 1e-4;
    const double rigidity = kE * std::pow(kThickness, 3) / (12 * (1 - 0.09));
    for (const bool jittered : {false, true}) {
        for (const Diagonal d : {Diagonal::kRising, Diagonal::kCrossed}) {
            SoftBodySpec spec = grid(cells, cells, edge, d, 0.3);
            const auto on_rim = [&](const Vec3& p) {
                return p.x() < 1e-9 || p.y() < 1e-9 || p.x() > side - 1e-9 || p.y() > side - 1e-9;
            };
            uint32_t seed = 5;
            for (Vec3& p : spec.mesh.rest) {
                if (!jittered || on_rim(p) || (p - Vec3(side / 2, side / 2, 0)).norm() < 1e-9)
                    continue;
                for (int a = 0; a < 2; ++a) {
                    seed = seed * 1664525U + 1013904223U;
                    p[a] += 0.3 * edge * (static_cast<double>(seed >> 8) / (1 << 24) - 0.5);
                }
            }
            const ReferenceBody body(spec);
            StaticProblem problem = hold(body, [&](const Vec3& p) {
                const bool corner = p.x() < 1e-9 && p.y() < 1e-9;
                return static_cast<uint8_t>((on_rim(p) ? 4 : 0) | (corner ? 3 : 0));
            });
            for (int v = 0; v < body.vertex_count(); ++v)
                problem.force_n[3 * v + 2] =
                    pressure / (1000 * kThickness) * body.mass_kg()[as_index(v)];
            Coordinates x = body.rest();
            ASSERT_TRUE(solve_static(problem, x, {1e-9, 100, 1}).converged);
            const double centre = x[3 * (cells / 2 * (cells + 1) + cells / 2) + 2];
            const double theory = 0.00406 * pressure * std::pow(side, 4) / rigidity;
            // Squares of a twelfth of the side: 4 %. Alternating diagonals twist too stiffly.
            if (d == Diagonal::kRising)
                EXPECT_NEAR(centre / theory, 1, 0.04) << jittered;
            else
                EXPECT_NEAR(centre / theory, 0.66, 0.04) << jittered;
        }
    }
}

TEST(Sheet, AHangingStripStretchesUnderItsWeight) {
    // vbd, settled: 1-D, rho g L^2 / (2 E) with free sides, while strains are small.
    SoftBodySpec spec = grid(1, 10, 1e-3);
    for (Vec3& p : spec.mesh.rest) p = Vec3(p.x(), 0, -p.y());
    for (Material& m : spec.materials) m.damping_per_s = 200;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        if (spec.mesh.rest[as_index(v)].z() == 0) spec.fixed.push_back(v);
    }
    const SoftBody body(spec);
    SoftBodyState state(body);
    Workers workers(1);
    run_substeps(body, state, 8000, workers);
    double low = 0;
    for (const Float4& p : state.x) low = std::min(low, static_cast<double>(p.z));
    const double sag = 1000 * 9.81 * 1e-4 / (2 * kE);
    // Held sides at the top keep the strip from narrowing there: 3 % of it.
    EXPECT_NEAR(-low - 10e-3, sag, 0.05 * sag);
}

TEST(Sheet, AFlapWeldedToTetsComesToTheEquilibriumOfNewton) {
    SoftBodySpec spec = flap_spec();
    const ReferenceBody reference(spec);
    StaticProblem problem =
        hold(reference, [](const Vec3& p) { return static_cast<uint8_t>(p.x() == 0 ? 7 : 0); });
    for (int v = 0; v < reference.vertex_count(); ++v)
        problem.force_n[3 * v + 2] = -9.81 * reference.mass_kg()[as_index(v)];
    Coordinates x = reference.rest();
    ASSERT_TRUE(solve_static(problem, x).converged);

    for (Material& m : spec.materials) m.damping_per_s = 40;
    const SoftBody body(spec);
    SoftBodyState state(body);
    Workers workers(1);
    run_substeps(body, state, 8000, workers);
    double error = 0, size = 0;
    Vec3 weld = Vec3::Zero(), weight = Vec3::Zero();
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Float4& p = state.x[as_index(v)];
        error += (Vec3(p.x, p.y, p.z) - Vec3(x.segment<3>(3 * v))).squaredNorm();
        size += (x.segment<3>(3 * v) - reference.rest().segment<3>(3 * v)).squaredNorm();
        if (body.tets_of(v).empty()) weight.z() -= 9.81 * body.mass_kg()[as_index(v)];
    }
    EXPECT_LT(std::sqrt(error / size), 0.005);
    // The weld carries the flap: what the sheet pulls on vertices of tets is the weight of the rest
    // of it.
    for (int v = 0; v < body.vertex_count(); ++v) {
        if (body.tets_of(v).empty()) continue;
        Mat3 unused = Mat3::Zero();
        add_sheet(body.packed().sheet, state.x.data(), v, weld, unused);
    }
    EXPECT_LT((weld + weight).norm(), 0.01 * weight.norm());
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
            const auto& t = s.sheet[6].vertex;
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

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a sheet comes to rest at: closed forms of homogeneous states, beam and plate theory, and
// double-precision equilibria.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sheet_specs.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/sheet.h"
#include "sim/verify/newton.h"

using namespace placode::sim;
using namespace placode::sim::test;

namespace THIS_TEST {

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

TEST(SheetStatics, UniaxialAndBiaxialStretchMeetTheClosedForms) {
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

TEST(SheetStatics, AClampedStripBendsAsBeamTheorySays) {
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

TEST(SheetStatics, ASimplySupportedPlateSagsAsPlateTheorySays) {
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

TEST(SheetStatics, AHangingStripStretchesUnderItsWeight) {
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

TEST(SheetStatics, AFlapWeldedToTetsComesToTheEquilibriumOfNewton) {
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

}  // namespace THIS_TEST

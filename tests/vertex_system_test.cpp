// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <random>

#include "sim/solver/soft_body.h"
#include "sim/solver/strip_walk.h"

using namespace placode::sim;

namespace THIS_TEST {

constexpr double kH = 2.5e-4;

/// VBD walks strips, XPBD goes tet by tet: the answer is the same.
class VertexSystemOf : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, VertexSystemOf, testing::Values(Method::kVbd, Method::kXpbd),
                         [](const auto& p) { return p.param == Method::kVbd ? "vbd" : "xpbd"; });

SoftBodySpec small_spec(Method method = Method::kVbd) {
    SoftBodySpec spec;
    spec.solver.method = method;
    spec.solver.allow_invalid = true;  // one vertex is looked at, nothing is stepped
    const TetMesh box = box_mesh(Vec3(3e-3, 2e-3, 2e-3), {3, 2, 2});
    spec.mesh = renumbered(box, rcm_order(box));
    for (size_t t = 0; t < spec.mesh.tets.size(); t += 3) spec.mesh.tissue[t] = Tissue::kSkin;
    spec.materials[static_cast<size_t>(Tissue::kSkin)].youngs_modulus_pa = 60e3;
    spec.materials[static_cast<size_t>(Tissue::kSkin)].poissons_ratio = 0.4;
    spec.rest_scale.assign(spec.mesh.tets.size(), {0.95F, 1.02F});
    spec.stiffness_percent.assign(spec.mesh.tets.size(), 100);
    spec.stiffness_percent[4] = 250;
    spec.springs.push_back({5, Vec3(1e-3, 0, -1e-4), Vec3(1, 2, 2), 3.0, 0.5});
    spec.springs.push_back({5, Vec3(2e-3, 0, 0), Vec3(0, 0, 1), 1.0, 0.0});
    spec.tethers.push_back({{2, 30}, 0.5e-3, 0.05, 1.0});
    return spec;
}

/// Energy in double, straight from F and the rest matrix: shares nothing with the kernels.
double energy(const SoftBody& body, const SoftBodyState& state, int vertex, const Vec3& at,
              bool elastic_only) {
    const SoftBodySpec& spec = body.spec();
    const auto position = [&](int v) {
        if (v == vertex) return at;
        const Float4& p = state.x[static_cast<size_t>(v)];
        return Vec3(p.x, p.y, p.z);
    };
    double sum = 0;
    for (const int32_t t : body.tets_of(vertex)) {
        const auto i = static_cast<size_t>(t);
        if (state.tet_alive[i] == 0) continue;
        const auto& tet = spec.mesh.tets[i];
        Mat3 rest, now;
        for (int k = 0; k < 3; ++k) {
            const auto other = static_cast<size_t>(tet[static_cast<size_t>(k) + 1]);
            const Vec3 e = spec.mesh.rest[other] - spec.mesh.rest[static_cast<size_t>(tet[0])];
            rest.col(k) = Vec3(e.x() * spec.rest_scale[i][0], e.y() * spec.rest_scale[i][0],
                               e.z() * spec.rest_scale[i][1]);
            now.col(k) = position(static_cast<int>(other)) - position(tet[0]);
        }
        const Mat3 f = now * rest.inverse();
        const Material& m = spec.materials[static_cast<size_t>(spec.mesh.tissue[i])];
        const NeoHookean c =
            neo_hookean(m.youngs_modulus_pa * spec.stiffness_percent[i] / 100.0, m.poissons_ratio);
        const double volume_term = f.determinant() - c.gamma;
        sum += rest.determinant() / 6 *
               (c.lambda_pa / 2 * volume_term * volume_term + c.mu_pa / 2 * (f.squaredNorm() - 3));
    }
    if (elastic_only) return sum;
    const Float4 &s = state.x_start[static_cast<size_t>(vertex)],
                 &v = state.v[static_cast<size_t>(vertex)];
    const Vec3 target =
        Vec3(s.x, s.y, s.z) + kH * Vec3(v.x, v.y, v.z) + kH * kH * spec.solver.gravity_m_s2;
    const double mass = body.mass_kg()[static_cast<size_t>(vertex)];
    sum += mass / (2 * kH * kH) * (at - target).squaredNorm();
    for (const AnchorSpring& spring : spec.springs) {
        if (spring.vertex != vertex) continue;
        const Vec3 n = spring.normal.normalized(), d = at - spring.anchor;
        const double along = n.dot(d);
        sum += spring.normal_n_m / 2 * along * along +
               spring.tangent_n_m / 2 * (d - along * n).squaredNorm();
    }
    for (size_t i = 0; i < spec.tethers.size(); ++i) {
        const Tether& tether = spec.tethers[i];
        if ((tether.vertex[0] != vertex && tether.vertex[1] != vertex) ||
            state.tether_alive[i] == 0) {
            continue;
        }
        const double excess =
            (position(tether.vertex[0]) - position(tether.vertex[1])).norm() - tether.rest_m;
        if (excess > 0) sum += excess * excess / (2 * tether.compliance_m_n);
    }
    return sum;
}

void scramble(SoftBodyState& state) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> jitter(-2e-4F, 2e-4F), speed(-0.1F, 0.1F);
    for (size_t i = 0; i < state.x.size(); ++i) {
        state.x_start[i] = state.x[i];
        state.x[i].x += jitter(random);
        state.x[i].y += jitter(random);
        state.x[i].z += jitter(random);
        state.v[i] = {speed(random), speed(random), speed(random), 0};
    }
}

Vec3 where(const SoftBodyState& state, int v) {
    const Float4& p = state.x[static_cast<size_t>(v)];
    return {p.x, p.y, p.z};
}

TEST_P(VertexSystemOf, GradientAndHessianAreTheDerivativesOfTheEnergy) {
    const SoftBody body(small_spec(GetParam()));
    SoftBodyState state(body);
    scramble(state);
    for (const int dead : {7, 20, 21}) remove_tet(body, state, dead);
    for (int v = 0; v < body.vertex_count(); ++v) {
        const VertexSystem system = vertex_system(body, state, v, kH);
        const Vec3 x = where(state, v);
        const double step = 1e-7;
        Vec3 gradient;
        Mat3 hessian;
        const auto e = [&](const Vec3& d) { return energy(body, state, v, x + d, false); };
        for (int a = 0; a < 3; ++a) {
            const Vec3 da = step * Vec3::Unit(a);
            gradient[a] = (e(da) - e(-da)) / (2 * step);
            for (int b = 0; b < 3; ++b) {
                const Vec3 db = step * Vec3::Unit(b);
                hessian(a, b) =
                    (e(da + db) - e(da - db) - e(db - da) + e(-da - db)) / (4 * step * step);
            }
        }
        // The constants are floats (1e-7 each); the lambda and mu terms nearly cancel, so errors
        // are measured against the size of the Hessian over the size of a jitter. Second
        // differences of an energy of 1e-7 J keep four digits.
        const double scale = hessian.norm();
        EXPECT_LT((system.gradient - gradient).norm(), 2e-6 * scale * 1e-3) << "vertex " << v;
        EXPECT_LT((system.hessian - hessian).norm(), 1e-3 * scale) << "vertex " << v;
        EXPECT_GT(system.hessian.selfadjointView<Eigen::Lower>().eigenvalues()[0], 0.0);
    }
}

TEST_P(VertexSystemOf, ElasticForceIsTheGradientWithoutTheRest) {
    const SoftBody body(small_spec(GetParam()));
    SoftBodyState state(body);
    scramble(state);
    for (int v = 0; v < body.vertex_count(); v += 5) {
        const Vec3 x = where(state, v);
        const double step = 1e-7;
        Vec3 force;
        for (int a = 0; a < 3; ++a) {
            const Vec3 d = step * Vec3::Unit(a);
            force[a] = (energy(body, state, v, x - d, true) - energy(body, state, v, x + d, true)) /
                       (2 * step);
        }
        EXPECT_LT((elastic_force(body, state, v) - force).norm(), 1e-4 * force.norm() + 1e-6);
    }
}

TEST_P(VertexSystemOf, ForcesOfAFreeBodyAddUpToNothing) {
    const SoftBody body(small_spec(GetParam()));
    SoftBodyState state(body);
    scramble(state);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Vec3 force = elastic_force(body, state, v);
        sum += force;
        moment += where(state, v).cross(force);
        size += force.norm();
    }
    // Float constants: 1e-7 of each of the pre-stress terms.
    EXPECT_LT(sum.norm(), 1e-5 * size);
    EXPECT_LT(moment.norm(), 1e-5 * size * 3e-3);
}

TEST_P(VertexSystemOf, ARemovedTetCarriesNoForce) {
    const SoftBody body(small_spec(GetParam()));
    SoftBodyState state(body);
    scramble(state);
    const int vertex = body.mesh().tets[10][0];
    for (const int32_t t : body.tets_of(vertex)) remove_tet(body, state, t);
    EXPECT_EQ(elastic_force(body, state, vertex), Vec3(0, 0, 0));
    for (int t = 0; t < body.tet_count(); ++t) remove_tet(body, state, t);
    for (int v = 0; v < body.vertex_count(); ++v) {
        EXPECT_EQ(elastic_force(body, state, v), Vec3(0, 0, 0));
    }
}

TEST_P(VertexSystemOf, RemovalDoesNotDependOnTheOrder) {
    const SoftBody body(small_spec(GetParam()));
    SoftBodyState a(body), b(body);
    for (const int t : {3, 14, 15, 40}) remove_tet(body, a, t);
    for (const int t : {40, 3, 15, 14}) remove_tet(body, b, t);
    EXPECT_EQ(a.lanes, b.lanes);
    EXPECT_EQ(state_hash(a), state_hash(b));
}

/// Recordings are replayed on other computers.
TEST(StripWalk, GivesTheSameBitsInRegistersAndInPlainNumbers) {
    const SoftBody body(small_spec());
    SoftBodyState state(body);
    scramble(state);
    for (const int dead : {7, 20, 21}) remove_tet(body, state, dead);
    for (const bool exact : {false, true}) {
        if (exact) {
            for (size_t i = 0; i < state.x.size(); ++i)
                state.x_low.push_back({3e-12F * static_cast<float>(i % 7), -2e-12F, 1e-12F, 0});
        }
        for (int v = 0; v < body.vertex_count(); ++v) {
            StripSums wide, plain;
            for (StripSums* sums : {&wide, &plain}) {
                sums->gradient = {1e-3, -2e-3, 3e-3, 0};
                sums->hessian = {5, 0.1, 0.2, 0, 0.3, 6, 0.4, 0, 0.5, 0.6, 7, 0};
            }
            walk_strip(packed_of(body, state), state, v, wide);
            walk_strip_plainly(packed_of(body, state), state, v, plain);
            for (const size_t i : {0, 1, 2}) {
                EXPECT_EQ(wide.gradient[i], plain.gradient[i]) << "vertex " << v;
                for (const size_t j : {0, 1, 2})
                    EXPECT_EQ(wide.hessian[4 * i + j], plain.hessian[4 * i + j]) << "vertex " << v;
            }
            EXPECT_NE(plain.gradient[0], 1e-3);
        }
    }
}

}  // namespace THIS_TEST

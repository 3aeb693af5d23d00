// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Positions that carry what a float has no room for (SoftBodyState::x_low).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/double_float.h"
#include "tests/instruction_sets.h"

using namespace placode::sim;

namespace THIS_TEST {

constexpr double kStep = 1e-5;  // [s]

/// A block of soft tissue that nothing holds; steps of 10 us.
SoftBodySpec block_spec(Method method, const Vec3& away) {
    SoftBodySpec spec;
    TetMesh box = box_mesh(Vec3(4, 3, 2) * 1e-3, {4, 3, 2}, Tissue::kPlacode);
    for (Vec3& p : box.rest) p += away;
    spec.mesh = renumbered(box, rcm_order(box));
    spec.solver.method = method;
    spec.solver.frame_s = 64 * kStep;
    spec.solver.substeps = 64;
    spec.solver.over_relaxation = 1;
    for (auto& m : spec.materials) m.damping_per_s = 0;
    return spec;
}

/// As stretched by 10 % along x.
SoftBodyState stretched(const SoftBody& body, bool double_float) {
    SoftBodyState state(body);
    if (double_float) use_double_float(state);
    for (int v = 0; v < body.vertex_count(); ++v) {
        Vec3 place = body.mesh().rest[as_index(v)];
        place.x() *= 1.1;
        put_vertex(state, v, place);
    }
    return state;
}

/// Mean over the mass.
Vec3 centre(const SoftBody& body, const SoftBodyState& state) {
    Vec3 sum = Vec3::Zero();
    double mass = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const double m = static_cast<double>(body.mass_kg()[as_index(v)]);
        sum += m * exact_position(state, v);
        mass += m;
    }
    return sum / mass;
}

/// |sum m v| over sum m |v|.
double momentum(const SoftBody& body, const SoftBodyState& state) {
    Vec3 sum = Vec3::Zero();
    double most = 0;
    for (int v = 0; v < body.vertex_count(); ++v) {
        const Vec3 p =
            static_cast<double>(body.mass_kg()[as_index(v)]) * to_vec(state.v[as_index(v)]);
        sum += p;
        most += p.norm();
    }
    return sum.norm() / most;
}

class LowParts : public ::testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Methods, LowParts,
                         ::testing::Values(Method::kVbd, Method::kXpbd, Method::kXpbdPair));

TEST_P(LowParts, AVertexIsWhereItWasPutAndMovedTo48Bits) {
    const SoftBody body(block_spec(GetParam(), Vec3::Zero()));
    SoftBodyState state(body);
    use_double_float(state);
    const Vec3 place(0.1234567890123456, -0.7, 3e-9), step(1e-12, -3e-11, 1e-15);
    put_vertex(state, 5, place);
    EXPECT_LT((exact_position(state, 5) - place).norm(), 1e-15 * 0.71 * 4);  // 2^-48 = 3.6e-15
    for (int i = 0; i < 1000; ++i) move_vertex(state, 5, step);
    EXPECT_LT((exact_position(state, 5) - (place + 1000 * step)).norm(), 2e-12);
    EXPECT_LT((to_vec(state.x[5]) - place).norm(), 6e-8) << "and the float is near it";
}

TEST_P(LowParts, ABodyFallsFarFromTheOriginHoweverShortTheStep) {
    const SoftBody body(block_spec(GetParam(), Vec3(0.3, 0.3, 0.3)));
    const double n = 64, expected = -9.81 * kStep * kStep * n * (n + 1) / 2;
    Workers workers(1);
    for (const bool low : {true, false}) {
        SoftBodyState state(body);
        if (low) use_double_float(state);
        const Vec3 before = centre(body, state);
        run_substeps(body, state, static_cast<int>(n), workers);
        const double fallen = (centre(body, state) - before).z();
        if (low) {
            EXPECT_NEAR(fallen / expected, 1, 1e-5);
        } else {
            // The first step is 1e-9 m, floats are 3e-8 m apart there.
            EXPECT_GT(std::abs(fallen / expected - 1), 1e-3);
        }
    }
}

TEST_P(LowParts, AreTheSameBitsWithAnyNumberOfThreads) {
    const SoftBody body(block_spec(GetParam(), Vec3::Zero()));
    const SoftBodyState start = stretched(body, true);
    SoftBodyState expected = start;
    Workers one(1);
    run_substeps(body, expected, 100, one);
    bool carried = false;
    for (const int threads : {2, 3, 8}) {
        SoftBodyState state = start;
        Workers workers(threads);
        run_substeps(body, state, 100, workers);
        EXPECT_EQ(state_hash(state), state_hash(expected)) << threads;
        for (size_t v = 0; v < state.x_low.size(); ++v) {
            EXPECT_EQ(to_vec(state.x_low[v]), to_vec(expected.x_low[v])) << v;
            carried = carried || to_vec(state.x_low[v]).norm() > 0;
        }
    }
    EXPECT_TRUE(carried);
}

TEST_P(LowParts, EveryInstructionSetAgrees) {
    const SoftBody body(block_spec(GetParam(), Vec3::Zero()));
    const SoftBodyState start = stretched(body, true);
    const auto after = [&] {
        Workers workers(1);
        SoftBodyState state = start;
        run_substeps(body, state, 100, workers);
        return state;
    };
    const SoftBodyState expected = after();
    placode::test::with_every_instruction_set([&] {
        const SoftBodyState state = after();
        for (int v = 0; v < body.vertex_count(); ++v) {
            // 1e-6 of the 0.4 mm that the block shrinks by; rounded positions agree to 2e-8.
            EXPECT_LT((exact_position(state, v) - exact_position(expected, v)).norm(), 4e-10)
                << kernel_target();
        }
    });
}

TEST_P(LowParts, ConserveTheMomentumThatTheMethodConserves) {
    SoftBodySpec spec = block_spec(GetParam(), Vec3::Zero());
    spec.solver.gravity_m_s2.setZero();
    const SoftBody body(std::move(spec));
    Workers workers(1);
    const auto after = [&](bool low) {
        SoftBodyState state = stretched(body, low);
        run_substeps(body, state, 500, workers);
        return momentum(body, state);
    };
    const double exact = after(true), rounded = after(false);
    EXPECT_LT(exact, GetParam() == Method::kVbd ? 1e-2 : 1e-6);
    EXPECT_LT(exact, rounded);
    RecordProperty("exact", std::to_string(exact));
    RecordProperty("rounded", std::to_string(rounded));
}

TEST_P(LowParts, AVertexThatIsNotFiniteComesBack) {
    const SoftBody body(block_spec(GetParam(), Vec3::Zero()));
    SoftBodyState state(body);
    use_double_float(state);
    Workers workers(1);
    run_substeps(body, state, 10, workers);
    const Vec3 good = exact_position(state, 20);
    state.x[20].y = std::numeric_limits<float>::quiet_NaN();
    state.x_low[20] = {std::numeric_limits<float>::quiet_NaN(), 0, 0, 0};
    run_substeps(body, state, 10, workers);
    EXPECT_NE(state.flags & kNotFinite, 0u);
    EXPECT_LT((exact_position(state, 20) - good).norm(), 1e-6);
    for (int v = 0; v < body.vertex_count(); ++v) {
        EXPECT_TRUE(exact_position(state, v).allFinite()) << v;
    }
}

TEST_P(LowParts, ContactVerticesAreLeftAloneByTheSweep) {
    const SoftBody body(block_spec(GetParam(), Vec3::Zero()));
    SoftBodyState state = stretched(body, true);
    Workers workers(1);
    begin_substep(body, state, kStep, workers);
    for (size_t v = 0; v < state.contact_vertex.size(); v += 3) state.contact_vertex[v] = 1;
    std::vector<Vec3> before;
    for (int v = 0; v < body.vertex_count(); ++v) before.push_back(exact_position(state, v));
    sweep(body, state, kStep, workers);
    for (int v = 0; v < body.vertex_count(); ++v) {
        const bool same = exact_position(state, v) == before[as_index(v)];
        EXPECT_EQ(same, state.contact_vertex[as_index(v)] != 0) << v;
    }
}

}  // namespace THIS_TEST

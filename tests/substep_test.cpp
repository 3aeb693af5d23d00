// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Threads, instruction sets, units, recovery, held and contact vertices, tethers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "sim/core/event.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/solver/soft_body.h"
#include "sim/solver/soft_body_kernels.h"
#include "sim/solver/vertex_motion.h"
#include "tests/instruction_sets.h"

using namespace placode::sim;
using placode::test::with_every_instruction_set;

namespace THIS_TEST {

SoftBodySpec slab_spec(Method method, const std::array<int, 3>& cells = {9, 7, 3}) {
    SoftBodySpec spec;
    const TetMesh box =
        box_mesh(Vec3(cells[0], cells[1], cells[2]) * 1e-3, cells, Tissue::kPlacode);
    spec.mesh = renumbered(box, rcm_order(box));
    spec.solver.method = method;
    spec.solver.substeps = method == Method::kVbd ? 4 : 8;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        const Vec3& p = spec.mesh.rest[static_cast<size_t>(v)];
        if (p.x() < 1e-9) spec.fixed.push_back(v);
        if (p.z() < 1e-9) spec.springs.push_back({v, p, Vec3::UnitZ(), 5.0, 1.0});
    }
    spec.tethers.push_back({{11, 60}, 1e-3, 1e-2, 1.0});
    return spec;
}

void poke(SoftBodyState& state, float size) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> jitter(-size, size);
    for (Float4& p : state.x) {
        if (p.w == 0) continue;
        p.x += jitter(random);
        p.y += jitter(random);
        p.z += jitter(random);
    }
}

Vec3 where(const SoftBodyState& state, int v) {
    const Float4& p = state.x[static_cast<size_t>(v)];
    return {p.x, p.y, p.z};
}

double farthest(const SoftBodyState& a, const SoftBodyState& b) {
    double worst = 0;
    for (int v = 0; v < static_cast<int>(a.x.size()); ++v) {
        worst = std::max(worst, (where(a, v) - where(b, v)).norm());
    }
    return worst;
}

class SubstepByMethod : public ::testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Methods, SubstepByMethod,
                         ::testing::Values(Method::kVbd, Method::kXpbd, Method::kXpbdPair));

TEST_P(SubstepByMethod, GivesTheSameBitsWithAnyNumberOfThreads) {
    const SoftBody body(slab_spec(GetParam()));
    uint64_t expected = 0;
    with_every_instruction_set([&] {
        for (int threads = 1; threads <= 8; ++threads) {
            if (threads > 4 && threads < 8) continue;
            Workers workers(threads);
            SoftBodyState state(body);
            poke(state, 5e-5F);
            for (const int t : {100, 101, 350}) remove_tet(body, state, t);
            run_substeps(body, state, 40, workers);
            const uint64_t hash = state_hash(state);
            if (threads == 1) expected = hash;
            EXPECT_EQ(hash, expected) << threads << " threads, " << kernel_target();
        }
    });
    Workers workers(1);
    SoftBodyState other(body);
    poke(other, 6e-5F);
    run_substeps(body, other, 40, workers);
    EXPECT_NE(state_hash(other), expected);
}

TEST(Substep, SweepsThereAndBackDependNeitherOnThreadsNorOnTheInstructionSet) {
    for (const Method method : {Method::kXpbd, Method::kXpbdPair}) {
        SoftBodySpec spec = slab_spec(method);
        EXPECT_FALSE(SoftBody(spec).turns()) << "too coarse a step";
        spec.solver.substeps = 32;
        const SoftBody body(std::move(spec));
        ASSERT_TRUE(body.turns());
        const auto run = [&](int threads, int substeps) {
            Workers workers(threads);
            SoftBodyState state(body);
            poke(state, 5e-5F);
            for (const int t : {100, 101, 350}) remove_tet(body, state, t);
            run_substeps(body, state, substeps, workers);
            return state;
        };
        const SoftBodyState reference = run(1, 20);
        with_every_instruction_set([&] {
            for (const int threads : {2, 3, 8}) {
                EXPECT_EQ(state_hash(run(threads, 41)), state_hash(run(1, 41)))
                    << threads << " threads, " << kernel_target();
            }
            // As in EveryInstructionSetAgrees.
            EXPECT_LT(farthest(run(1, 20), reference), 2e-8) << kernel_target();
        });
    }
}

/// Vertices as they come in a step: held ones, free ones among others, zeros of both signs.
void scatter(SoftBodyState& state) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    const auto number = [&]() -> float {
        const unsigned kind = random() % 8;
        return kind == 0 ? 0.0F : kind == 1 ? -0.0F : 1e-3F * any(random);
    };
    for (size_t i = 0; i < state.x.size(); ++i) {
        state.x[i] = {number(), number(), number(), random() % 5 == 0 ? 0.0F : 3e5F};
        state.x_start[i] = {number(), number(), number(), state.x[i].w};
        state.v[i] = {number(), number(), number(), 0};
        state.free_vertex[i] = i > 200 && random() % 9 == 0 ? 1 : 0;
    }
}

// A vertex's bits must not depend on who does it: shares of threads end anywhere.
TEST(Substep, MotionHasTheSameBitsByKernelAndByHand) {
    const SoftBody body(slab_spec(Method::kVbd));
    const std::vector<float> damping(body.mesh().rest.size() + 4, 3.7F);
    std::mt19937 random(8);
    with_every_instruction_set([&] {
        for (const bool gravity : {false, true}) {
            SoftBodyState by_hand(body), by_kernel(body);
            scatter(by_hand);
            scatter(by_kernel);
            const auto motion_of = [&](SoftBodyState& state) {
                MotionArguments m;
                m.x = state.x.data();
                m.v = state.v.data();
                m.x_start = state.x_start.data();
                m.free_vertex = state.free_vertex.data();
                m.damping_per_s = damping.data();
                m.h = 2.5e-4F;
                m.fall_m_s = {0, -0.0F, -2.45e-3F, 0};
                m.gravity_in_guess = gravity;
                m.fused = kernels_fuse();
                return m;
            };
            const MotionArguments plain = motion_of(by_hand), wide = motion_of(by_kernel);
            VertexMotion one(by_hand, plain), rest(by_kernel, wide);
            const size_t n = by_hand.x.size();
            size_t done_by_kernel = 0;
            for (const bool begin : {false, true, false}) {
                for (size_t i = 0; i < n; ++i) begin ? one.begin(i) : one.end(i);
                for (size_t i = 0; i < n;) {
                    const size_t last = std::min(n, i + 1 + random() % 40);
                    const size_t from = i;
                    i = begin ? begin_motion(wide, i, last) : end_motion(wide, i, last);
                    done_by_kernel += i - from;
                    for (; i < last; ++i) begin ? rest.begin(i) : rest.end(i);
                }
                EXPECT_EQ(std::memcmp(by_hand.x.data(), by_kernel.x.data(), n * sizeof(Float4)), 0)
                    << kernel_target() << " gravity " << gravity << " begin " << begin;
                EXPECT_EQ(std::memcmp(by_hand.v.data(), by_kernel.v.data(), n * sizeof(Float4)), 0)
                    << kernel_target() << " gravity " << gravity << " begin " << begin;
            }
            const bool scalar = std::string(kernel_target()) == "SCALAR";
            EXPECT_EQ(done_by_kernel > n, !scalar) << kernel_target();
        }
    });
}

TEST_P(SubstepByMethod, TheThreeCallsAndRunSubstepsAreTheSameBits) {
    SoftBodySpec spec = slab_spec(GetParam());
    spec.solver.iterations = 2;
    const SoftBody body(std::move(spec));
    Workers workers(2);
    SoftBodyState a(body), b(body);
    poke(a, 5e-5F);
    poke(b, 5e-5F);
    run_substeps(body, a, 10, workers);
    const double h = body.spec().solver.frame_s / body.spec().solver.substeps;
    for (int i = 0; i < 10; ++i) {
        begin_substep(body, b, h, workers);
        sweep(body, b, h, workers);
        sweep(body, b, h, workers);
        end_substep(body, b, h, workers);
    }
    EXPECT_EQ(state_hash(a), state_hash(b));
}

TEST_P(SubstepByMethod, EveryInstructionSetAgrees) {
    const SoftBody body(slab_spec(GetParam()));
    Workers workers(1);
    SoftBodyState reference(body);
    poke(reference, 5e-5F);
    run_substeps(body, reference, 20, workers);
    const int tried = with_every_instruction_set([&] {
        SoftBodyState state(body);
        poke(state, 5e-5F);
        run_substeps(body, state, 20, workers);
        // Fused or separate rounding: 1e-7 of a coordinate a substep, carried on by the waves.
        EXPECT_LT(farthest(state, reference), 2e-8) << kernel_target();
    });
    EXPECT_GE(tried, 1);
}

TEST_P(SubstepByMethod, TheUnitSystemDoesNotMatter) {
    // Millimetres, grams, seconds: stress in g / (mm s^2) = Pa, forces in uN.
    SoftBodySpec si = slab_spec(GetParam());
    SoftBodySpec mm = si;
    for (Vec3& p : mm.mesh.rest) p *= 1e3;
    for (Material& m : mm.materials) m.density_kg_m3 *= 1e-6;
    for (AnchorSpring& s : mm.springs) {
        s.anchor *= 1e3;
        s.normal_n_m *= 1e3;
        s.tangent_n_m *= 1e3;
    }
    for (Tether& t : mm.tethers) {
        t.rest_m *= 1e3;
        t.compliance_m_n *= 1e-3;
        t.break_n *= 1e6;
    }
    mm.solver.gravity_m_s2 *= 1e3;
    const SoftBody a(std::move(si)), b(std::move(mm));
    SoftBodyState sa(a), sb(b);
    Workers workers(1);
    run_substeps(a, sa, 200, workers);
    run_substeps(b, sb, 200, workers);
    double moved = 0;
    for (int v = 0; v < a.vertex_count(); ++v) {
        moved = std::max(moved, (where(sa, v) - a.mesh().rest[static_cast<size_t>(v)]).norm());
        // Same arithmetic, other rounding: 1e-9 m is one unit in the last place of 9 mm, and XPBD
        // rounds once per tet.
        EXPECT_LT((where(sa, v) - where(sb, v) * 1e-3).norm(), 1e-7);
    }
    EXPECT_GT(moved, 1e-5);
}

TEST_P(SubstepByMethod, RecoversFromMirroredAndFlatShapes) {
    // Courant number .27: small enough for XPBD.
    for (const float factor : {-1.0F, 0.0F}) {
        SoftBodySpec spec;
        const TetMesh box = box_mesh(Vec3(2e-3, 2e-3, 2e-3), {2, 2, 2}, Tissue::kPlacode);
        spec.mesh = renumbered(box, rcm_order(box));
        spec.solver.method = GetParam();
        spec.solver.gravity_m_s2.setZero();
        spec.solver.substeps = 16;
        const SoftBody body(std::move(spec));
        SoftBodyState state(body);
        for (size_t i = 0; i < state.x.size(); ++i) {
            // A nudge out of the exact symmetry, as every real state has.
            state.x[i].z = state.x[i].z * factor + 1e-5F * static_cast<float>(i % 3);
        }
        Workers workers(1);
        run_substeps(body, state, 16 * 2000, workers);
        for (int t = 0; t < body.tet_count(); ++t) {
            TetMesh now = body.mesh();
            const auto& tet = now.tets[static_cast<size_t>(t)];
            for (const int32_t v : tet) now.rest[static_cast<size_t>(v)] = where(state, v);
            EXPECT_NEAR(rest_volume(now, t) / rest_volume(body.mesh(), t), 1.0, 0.02)
                << "tet " << t << " from " << factor;
        }
    }
}

TEST_P(SubstepByMethod, ContactVerticesAreLeftAloneByTheSweep) {
    const SoftBody body(slab_spec(GetParam()));
    SoftBodyState state(body);
    poke(state, 1e-4F);
    Workers workers(1);
    const double h = 2.5e-4;
    begin_substep(body, state, h, workers);
    for (size_t v = 0; v < state.contact_vertex.size(); v += 3) state.contact_vertex[v] = 1;
    const std::vector<Float4> before = state.x;
    sweep(body, state, h, workers);
    int moved = 0;
    for (size_t v = 0; v < before.size(); ++v) {
        const bool same = before[v].x == state.x[v].x && before[v].y == state.x[v].y &&
                          before[v].z == state.x[v].z;
        if (state.contact_vertex[v] != 0) {
            EXPECT_TRUE(same) << v;
        }
        EXPECT_EQ(before[v].w, state.x[v].w) << v;
        moved += same ? 0 : 1;
    }
    EXPECT_GT(moved, body.vertex_count() / 2);
}

TEST_P(SubstepByMethod, HeldVerticesFollowTheCallerOnly) {
    const SoftBody body(slab_spec(GetParam()));
    SoftBodyState state(body);
    Workers workers(1);
    const int held = 150;
    state.x[held].w = 0;
    for (int i = 1; i <= 40; ++i) {
        state.x[held].z += 1e-6F;
        const Float4 put = state.x[held];
        run_substeps(body, state, 1, workers);
        ASSERT_EQ(state.x[held].z, put.z);
        ASSERT_EQ(state.x[held].x, put.x);
    }
    // Pulled up by 40 um: the tissue pulls back.
    EXPECT_LT(elastic_force(body, state, held).z(), 0);
}

TEST_P(SubstepByMethod, ExternalForcesAccelerateByTheirSumOverTheMass) {
    SoftBodySpec spec = slab_spec(GetParam());
    spec.fixed.clear();
    spec.springs.clear();
    spec.tethers.clear();
    spec.solver.gravity_m_s2.setZero();
    for (auto& m : spec.materials) m.damping_per_s = 0;
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    state.force_n.resize(state.x.size());
    double mass = 0, moved = 0;
    for (size_t i = 0; i < state.x.size(); ++i) {
        const float m = body.mass_kg()[i];
        state.force_n[i] = {0, 0, 2 * m, 0};
        mass += static_cast<double>(m);
    }
    Workers workers(2);
    const int n = 80;
    run_substeps(body, state, n, workers);
    const double h = body.spec().solver.frame_s / body.spec().solver.substeps, t = n * h;
    for (size_t i = 0; i < state.x.size(); ++i) {
        moved += static_cast<double>(body.mass_kg()[i]) / mass *
                 (static_cast<double>(state.x[i].z) - body.mesh().rest[i].z());
    }
    // First order in time, as free fall; floats keep 1e-3 of a way of 0.1 mm.
    EXPECT_NEAR(moved, 2 * t * (t + h) / 2, 2e-3 * t * t);
}

TEST(Substep, AForceOnAHeldBodyIsBalancedByTheTissue) {
    SoftBodySpec spec = slab_spec(Method::kVbd);
    spec.solver.gravity_m_s2.setZero();
    for (auto& m : spec.materials) m.damping_per_s = 40;
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    state.force_n.resize(state.x.size());
    size_t loaded = 0;
    while (state.x[loaded].w == 0) ++loaded;
    state.force_n[loaded] = {0, 0, 1e-4F, 0};
    Workers workers(1);
    run_substeps(body, state, 4000, workers);
    const Vec3 answer = elastic_force(body, state, static_cast<int>(loaded));
    EXPECT_NEAR(answer.z(), -1e-4, 1e-6);
    EXPECT_LT(answer.head<2>().norm(), 1e-6);
}

TEST_P(SubstepByMethod, ABodyShrunkToAPointIsSeededFromItsRestShape) {
    SoftBodySpec spec = slab_spec(GetParam());
    spec.fixed.clear();
    spec.springs.clear();
    spec.tethers.clear();
    spec.solver.gravity_m_s2.setZero();
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    EXPECT_EQ(restore_collapsed(body, state), 0);
    EXPECT_EQ(state.flags & kRestShapeRestored, 0u);
    for (Float4& x : state.x) x = {0.25F, 0, 0, x.w};
    Workers workers(1);
    run_substeps(body, state, 20, workers);
    EXPECT_LT((Vec3(state.x[0].x, state.x[0].y, state.x[0].z) - Vec3(0.25, 0, 0)).norm(), 1e-6)
        << "a point cannot leave its state by itself";
    EXPECT_EQ(restore_collapsed(body, state), body.vertex_count());
    EXPECT_NE(state.flags & kRestShapeRestored, 0u);
    for (const auto& tet : body.mesh().tets) {
        const auto edge = [&](auto&& at) { return (at(tet[1]) - at(tet[0])).norm(); };
        const double now = edge([&](int32_t v) {
            const Float4& x = state.x[static_cast<size_t>(v)];
            return Vec3(x.x, x.y, x.z);
        });
        const double rest =
            edge([&](int32_t v) { return body.mesh().rest[static_cast<size_t>(v)]; });
        EXPECT_NEAR(now, rest, 1e-7);  // floats at 0.25 m
    }
}

TEST_P(SubstepByMethod, AVertexThatIsNotFiniteIsPutBackAndReported) {
    const SoftBody body(slab_spec(GetParam()));
    SoftBodyState state(body);
    Workers workers(2);
    run_substeps(body, state, 20, workers);
    EXPECT_EQ(state.flags & kNotFinite, 0u);
    const double h = body.spec().solver.frame_s / body.spec().solver.substeps;
    const SoftBodyState good = state;
    begin_substep(body, state, h, workers);
    state.x[120].y = std::numeric_limits<float>::quiet_NaN();
    sweep(body, state, h, workers);
    end_substep(body, state, h, workers);
    EXPECT_NE(state.flags & kNotFinite, 0u);
    EXPECT_EQ(where(state, 120), where(good, 120));
    EXPECT_EQ(state.v[120].y, 0.0F);
    // Between substeps as well.
    state.x[90].x = std::numeric_limits<float>::infinity();
    state.v[91].z = std::numeric_limits<float>::quiet_NaN();
    state.flags = 0;
    run_substeps(body, state, 20, workers);
    EXPECT_NE(state.flags & kNotFinite, 0u);
    // The rest of the body goes on as if nothing had happened.
    SoftBodyState undisturbed(body);
    run_substeps(body, undisturbed, 41, workers);
    EXPECT_LT(farthest(state, undisturbed), 3e-4);
    for (const Float4& v : state.v) EXPECT_TRUE(std::isfinite(v.x + v.y + v.z));
}

TEST_P(SubstepByMethod, ATetherPullsOneWayAndBreaks) {
    // Two cubes, one fixed, one hanging from a tether: the tether carries its weight.
    SoftBodySpec spec;
    TetMesh low = box_mesh(Vec3(1e-3, 1e-3, 1e-3), {1, 1, 1}, Tissue::kPlacode);
    const TetMesh high = low;
    for (const Vec3& p : high.rest) low.rest.push_back(p + Vec3(0, 0, 4e-3));
    for (auto tet : high.tets) {
        for (int32_t& v : tet) v += 8;
        low.tets.push_back(tet);
        low.tissue.push_back(Tissue::kPlacode);
    }
    spec.mesh = low;
    spec.solver.method = GetParam();
    spec.solver.substeps = 16;
    for (int v = 8; v < 16; ++v) spec.fixed.push_back(v);
    spec.materials[static_cast<size_t>(Tissue::kPlacode)].damping_per_s = 60;
    // 1 mg under 9.81 m/s^2: 9.81 uN on .05 m/N is .5 um.
    spec.tethers.push_back({{4, 8}, 3e-3, 0.05, 20e-6});
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    Workers workers(1);
    run_substeps(body, state, 16 * 600, workers);
    EXPECT_EQ(state.tether_alive[0], 1);
    EXPECT_NEAR(state.tether_lambda_n[0], 9.81e-6, 0.05 * 9.81e-6);
    // Slack: no force.
    SoftBodyState slack(body);
    for (size_t v = 0; v < 8; ++v) slack.x[v].z += 1e-3F;
    run_substeps(body, slack, 1, workers);
    EXPECT_EQ(slack.tether_lambda_n[0], 0.0F);
    // A jerk breaks it.
    for (size_t v = 0; v < 8; ++v) state.v[v].z = -0.5F;
    run_substeps(body, state, 16 * 4, workers);
    EXPECT_EQ(state.tether_alive[0], 0);
    EXPECT_GT(state.tether_lambda_n[0], 20e-6F) << "the force that broke it, for the ledger";
}

TEST(Substep, LooseComponentsAreFoundAgainAfterACut) {
    const SoftBody body(slab_spec(Method::kVbd));
    SoftBodyState state(body);
    for (const uint8_t free : state.free_vertex) ASSERT_EQ(free, 0);
    // Cut one corner vertex's tets off everything that holds.
    const int loose = body.mesh().tets.back()[0];
    for (int t = 0; t < body.tet_count(); ++t) remove_tet(body, state, t);
    update_free_vertices(body, state);
    bool held = false;
    for (const int32_t v : body.spec().fixed) held |= v == loose;
    for (const AnchorSpring& s : body.spec().springs) held |= s.vertex == loose;
    EXPECT_EQ(state.free_vertex[static_cast<size_t>(loose)], held ? 0 : 1);
    int free = 0;
    for (const uint8_t f : state.free_vertex) free += f;
    EXPECT_GT(free, body.vertex_count() / 2);
}

TEST(Substep, AScrambledStiffSlabSettlesUnderVbd) {
    // Vertices thrown about by 30 % of an edge, Courant number about 11.
    SoftBodySpec spec = slab_spec(Method::kVbd);
    spec.materials[static_cast<size_t>(Tissue::kPlacode)].youngs_modulus_pa = 500e3;
    const SoftBody body(std::move(spec));
    SoftBodyState calm(body), state(body);
    poke(state, 3e-4F);
    Workers workers(2);
    run_substeps(body, calm, 8000, workers);
    run_substeps(body, state, 8000, workers);
    EXPECT_LT(farthest(calm, state), 1e-5);
    EXPECT_EQ(state.flags & kNotFinite, 0u);
}

}  // namespace THIS_TEST

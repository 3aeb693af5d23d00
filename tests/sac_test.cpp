// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid of a cystic lesion: pressure, leak, and a membrane that sinks onto the canal.

#include "sim/cutting/sac.h"
#include "sim/world/add_event.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/anatomy/operative_field.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/tissue_stretch.h"
#include "sim/solver/kernel_layout.h"
#include "sim/step/step.h"

namespace placode::sim {
namespace THIS_TEST {

using ::testing::HasSubstr;

OperativeFieldSpec cystic(double edge_m = 0.001) {
    OperativeFieldSpec spec;
    spec.id = "cystic";
    spec.cystic = true;
    spec.dome_height_m = 0.005;
    spec.dome_exponent = 1;
    spec.sac.pressure_pa = 200;
    spec.sac.floor_drag_n_m = 20;
    spec.placode_prestretch = 1.1;
    spec.placode_layers_m = {0.0006, 0.0006, 0.0007, 0.0008};
    spec.ring_layers_m = {0.00025, 0.00025, 0.001, 0.0008};
    spec.materials[static_cast<size_t>(Tissue::kZone)].youngs_modulus_pa = 12000;
    spec.edge_ring_m = edge_m;
    spec.edge_placode_m = 1.2 * edge_m;
    spec.edge_outer_m = 2.2 * edge_m;
    spec.tethers = 12;
    spec.tether_break_n = 0.5;
    return spec;
}

const Scene& field() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(cystic());
    return *scene;
}

std::string refusal(const OperativeFieldSpec& spec) {
    try {
        (void)build_operative_field(spec);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "built";
}

Vec3 place(const State& state, int32_t v) {
    const Float4& x = state.body.x[static_cast<size_t>(v)];
    return {x.x, x.y, x.z};
}

/// Load on a vertex of the underside as the solver sees it.
Vec3 load_on(const State& state, int32_t v) {
    const KernelLayout& packed = packed_of(field().body, state.body);
    const int32_t slot = packed.slot[static_cast<size_t>(v)];
    const float* row = state.body.springs.data() +
                       packed.batches[static_cast<size_t>(slot / kLanes)].spring_start +
                       slot % kLanes;
    return -Vec3(row[9 * kLanes], row[10 * kLanes], row[11 * kLanes]);
}

/// Burns a hole of this radius through the wall at a place of the plane.
int open_hole(const Scene& scene, State& state, const Vec2& where, double radius_m) {
    int gone = 0;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        const Vec3 c = rest_centroid(scene, t);
        if (scene.body.mesh().tissue[static_cast<size_t>(t)] != Tissue::kZone) continue;
        if ((c.head<2>() - where).norm() > radius_m) continue;
        take_out(scene, state, t);
        ++gone;
    }
    return gone;
}

double placode_height(const Scene& scene, const State& state) {
    double sum = 0;
    int n = 0;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        if (scene.body.mesh().tissue[static_cast<size_t>(t)] != Tissue::kPlacode) continue;
        for (const int32_t v : scene.body.mesh().tets[static_cast<size_t>(t)]) {
            sum += place(state, v).z();
            ++n;
        }
    }
    return sum / n;
}

void frames(const Scene& scene, State& state, int count, std::vector<Event>* events = nullptr) {
    for (int i = 0; i < count; ++i) {
        step(scene, state, {}, {});
        for (int e = 0; events != nullptr && e < state.event_count; ++e) {
            events->push_back(state.events[static_cast<size_t>(e)]);
        }
    }
}

TEST(Sac, TheLoadIsPressureTimesTheGradientOfTheVolume) {
    const Scene& scene = field();
    State state(scene, 1);
    update_sac(scene, state, 1e-3, true);
    ASSERT_GT(scene.sac.vertices.size(), 100u);
    for (size_t i = 0; i < scene.sac.vertices.size(); i += 17) {
        const int32_t v = scene.sac.vertices[i];
        Vec3 gradient;
        // Volume is linear in one vertex; positions are floats, hence a large step.
        const float step_m = 1e-3F;
        for (int k = 0; k < 3; ++k) {
            float* c = &state.body.x[static_cast<size_t>(v)].x + k;
            const float before = *c;
            *c = before + step_m;
            const double more = sac_volume(scene.sac, state);
            *c = before - step_m;
            const double less = sac_volume(scene.sac, state);
            *c = before;
            gradient[k] = (more - less) / (2.0 * static_cast<double>(step_m));
        }
        // 1e-5 of the load: it is kept as a float.
        EXPECT_LT((load_on(state, v) - 200 * gradient).norm(), 1e-5 * 200 * gradient.norm());
    }
}

TEST(Sac, AFixedWallLeaksLikeAnOrifice) {
    const Scene& scene = field();
    State state(scene, 1);
    update_sac(scene, state, 1e-3, true);
    update_sac(scene, state, 1e-3, false);
    EXPECT_NEAR(state.sac.pressure_pa, 200, 1e-9);
    // The wall does not move: sqrt(p) falls by kappa Cd A / sqrt(2 rho) every second.
    ASSERT_GT(open_hole(scene, state, Vec2(-0.0095, 0), 0.0009), 0);
    double t = 0;
    const double dt = 1e-4;
    for (int i = 0; i < 3000; ++i, t += dt) update_sac(scene, state, dt, false);
    ASSERT_GT(state.sac.hole_m2, 2e-7);
    const SacSettings& s = scene.sac.settings;
    const double slope =
        s.stiffness_pa_m3 * s.discharge * state.sac.hole_m2 / std::sqrt(2 * s.fluid_density_kg_m3);
    const double expected = std::pow(std::max(0.0, std::sqrt(200.0) - slope * t), 2);
    ASSERT_GT(expected, 1);  // or the comparison says nothing
    // Explicit Euler in 3,000 steps.
    EXPECT_NEAR(state.sac.pressure_pa, expected, 2e-3 * expected);
    EXPECT_NEAR(state.sac.leaked_m3, (200 - state.sac.pressure_pa) / s.stiffness_pa_m3, 1e-15);
}

TEST(Sac, AnIntactSacStandsStillAndSleeps) {
    const Scene& scene = field();
    State state(scene, 1);
    settle(scene, state, 0.5);
    const double height = placode_height(scene, state);
    EXPECT_GT(height, 0.003);
    std::vector<Event> events;
    frames(scene, state, 1500, &events);
    // 20 um: the last of the settling.
    EXPECT_NEAR(placode_height(scene, state), height, 2e-5);
    EXPECT_NEAR(state.sac.pressure_pa, 200, 5);
    EXPECT_EQ(state.sac.hole_m2, 0);
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const Event& e) {
                                return e.kind == EventKind::kSacOpened ||
                                       e.kind == EventKind::kTorn;
                            }),
              0);
    EXPECT_TRUE(state.sleep.still());
}

TEST(Sac, OpenedItEmptiesAndThePlacodeSinksOntoTheCanal) {
    const Scene& scene = field();
    State state(scene, 1);
    settle(scene, state, 0.5);
    const double height = placode_height(scene, state);
    std::vector<Event> events;
    frames(scene, state, 50, &events);
    ASSERT_GT(open_hole(scene, state, Vec2(-0.0095, 0), 0.0012), 0);
    frames(scene, state, 4000, &events);
    EXPECT_LT(state.sac.pressure_pa, 5);
    EXPECT_GT(state.sac.leaked_m3, 5e-7);
    EXPECT_LT(placode_height(scene, state), height - 0.003);
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const Event& e) { return e.kind == EventKind::kSacOpened; }),
              1);
    for (const int32_t v : scene.sac.vertices) {
        const Vec3 x = place(state, v);
        // The floor answers with 20 N/m at each vertex: weight alone presses in some microns.
        EXPECT_GT(x.z(), scene.sac.floor.at(x.x(), x.y()) - 1e-4);
    }
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
        EXPECT_LT(principal_stretch(scene, state, t), 1.8) << "tet " << t;
    }
}

TEST(Sac, SameBitsOnAnyNumberOfThreads) {
    const Scene& scene = field();
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
        State state(scene, threads);
        settle(scene, state, 0.05);
        open_hole(scene, state, Vec2(-0.0095, 0), 0.0012);
        frames(scene, state, 60);
        hashes.push_back(state_hash(state));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Sac, TheDefaultFieldIsSound) {
    OperativeFieldSpec spec = cystic(0.0005);
    spec.edge_placode_m = 0.0008;
    spec.edge_outer_m = 0.0016;
    const auto scene = build_operative_field(spec);
    double least = 1;
    for (int t = 0; t < scene->body.tet_count(); ++t) {
        least = std::min(least, tet_quality(scene->body.mesh(), t));
    }
    EXPECT_GE(least, 0.1);
    EXPECT_GT(scene->body.tet_count(), 30000);
    EXPECT_LT(scene->body.tet_count(), 45000);
}

TEST(Sac, RefusesWhatItCannotDo) {
    OperativeFieldSpec spec = cystic();
    spec.solver.method = Method::kXpbd;
    EXPECT_THAT(refusal(spec), HasSubstr("needs vbd"));
    spec = cystic();
    spec.sac.pressure_pa = 1e5;
    EXPECT_THAT(refusal(spec), HasSubstr("sac.pressure_pa"));
    spec = cystic();
    spec.dome_exponent = 0.75;
    EXPECT_THAT(refusal(spec), HasSubstr("dome_exponent"));
    spec = cystic();
    spec.cystic = false;
    spec.dome_exponent = 0.75;
    EXPECT_THAT(refusal(spec), HasSubstr("dome_height_m"));
}

}  // namespace THIS_TEST
}  // namespace placode::sim

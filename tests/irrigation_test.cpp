// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Jet, standing fluid, suction and debris against closed forms, and the state that they keep.
#include "sim/fluid/irrigation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "sim/anatomy/operative_field.h"
#include "sim/fluid/jet_law.h"
#include "sim/fluid/pool.h"
#include "sim/fluid/surface_ray.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

/// A level pad with a placode of 4 x 3 mm, one irrigator, no debris.
OperativeFieldSpec level_pad() {
    OperativeFieldSpec spec;
    spec.domain_x_m = 0.022;
    spec.domain_y_m = 0.018;
    spec.edge_ring_m = spec.edge_placode_m = 0.0010;
    spec.edge_outer_m = 0.0020;
    spec.skin_edge_a_m = 0.005;
    spec.skin_edge_b_m = 0.004;
    spec.placode_a_m = 0.002;
    spec.placode_b_m = 0.0015;
    spec.contour_offset_m = 0.001;
    spec.thin_skin_width_m = 0.001;
    spec.dome_height_m = spec.rim_height_m = spec.groove_depth_m = 0;
    spec.relief_skin_m = spec.relief_placode_m = spec.wobble = 0;
    spec.base_radius_x_m = spec.base_radius_y_m = 1e5;
    spec.skin_prestretch = spec.zone_prestretch = 1;
    spec.heat = false;
    spec.irrigation.emplace();
    spec.irrigation->crumbs = spec.irrigation->spots = 0;
    spec.irrigation->start_m3 = 0;
    ToolSpec tool;
    tool.kind = ToolKind::kIrrigator;
    tool.tip_radius_m = tool.shaft_radius_m = 0.0015;
    spec.tools = {tool};
    return spec;
}

/// One for all tests that need nothing else: building it takes longer than they do.
const std::shared_ptr<const Scene>& level_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(level_pad());
    return scene;
}

/// A pad with three crumbs, three spots and some fluid.
const std::shared_ptr<const Scene>& soiled_scene() {
    static const std::shared_ptr<const Scene> scene = [] {
        OperativeFieldSpec spec = level_pad();
        spec.irrigation->crumbs = spec.irrigation->spots = 3;
        spec.irrigation->start_m3 = 2e-8;
        return build_operative_field(spec);
    }();
    return scene;
}

/// Holds the irrigator `gap_m` over a place, `tilt` from upright, with pedals down.
class Hand {
 public:
    Hand(const Scene& scene, int threads = 1) : scene_(scene), state(scene, threads) {}
    void hold(const Vec3& tip, double tilt, uint8_t pedals, int frames) {
        ToolInput input;
        // +z of the tool looks down.
        const Quat turn = Quat(Eigen::AngleAxisd(kPi - tilt, Vec3::UnitX()));
        input.set_pose({tip, turn});
        input.engaged = 1;
        input.pedals = pedals;
        ToolFeedback feedback;
        for (int i = 0; i < frames; ++i) (void)step(scene_, state, {&input, 1}, {&feedback, 1});
    }
    [[nodiscard]] Vec3 load() const {
        Vec3 sum = Vec3::Zero();
        for (const auto& n : state.irrigation.load_n)
            for (int k = 0; k < 3; ++k) sum[k] += static_cast<double>(n[static_cast<size_t>(k)]);
        return sum;
    }

 private:
    const Scene& scene_;

 public:
    State state;
};

TEST(JetLaw, PressureAddsUpToTheMomentumFlux) {
    const JetSpec jet;
    EXPECT_NEAR(jet_flow_m3_s(jet), 1.2 * kPi / 4 * 0.64e-6, 1e-12);
    for (const double x : {0.001, 0.004, 0.010, 0.030}) {
        const double b = jet_width_m(jet, x);
        double sum = 0;
        const int rings = 4000;
        for (int i = 0; i < rings; ++i) {
            const double r = 6 * b * (i + 0.5) / rings;
            sum += jet_pressure_pa(jet, x, r, 1) * 2 * kPi * r * 6 * b / rings;
        }
        EXPECT_NEAR(sum / jet_momentum_n(jet), 1, 1e-5) << x;
        // In its core the jet has its speed; beyond, half of it at twice the way.
        EXPECT_NEAR(jet_pressure_pa(jet, x, 0, 1),
                    0.5 * 1000 * 1.44 * std::pow(std::min(1.0, jet_core_m(jet) / x), 2), 1e-9);
        EXPECT_NEAR(jet_shear_pa(jet, x, 0), 0, 1e-12);
        const double most = jet_shear_pa(jet, x, b);
        EXPECT_LT(jet_shear_pa(jet, x, 0.9 * b), most);
        EXPECT_LT(jet_shear_pa(jet, x, 1.1 * b), most);
    }
    // 44.6 rho v^2 Re^-1/2 (d / x)^2, Re = 1371.
    EXPECT_NEAR(jet_shear_pa(jet, 0.01, jet_width_m(jet, 0.01)),
                44.6 * 1440 / std::sqrt(1371.43) * 0.0064, 0.01);
}

TEST(Jet, ForceOnALevelFieldIsTheMomentumFluxAlongItsNormal) {
    const auto& scene = level_scene();
    for (const double tilt : {0.0, 0.5, 0.9}) {
        Hand hand(*scene);
        const double away = 0.008;
        const Vec3 from(0, away * std::sin(tilt), away * std::cos(tilt));
        hand.hold(from, tilt, kPedalCut, 1);
        hand.hold(from, tilt, kPedalCut, 1);
        const double wanted = jet_momentum_n(scene->irrigation->jet) * std::cos(tilt);
        EXPECT_NEAR(-hand.load().z() / wanted, 1, 2e-3) << tilt;
        EXPECT_LT(hand.load().head<2>().norm(), 0.01 * wanted) << tilt;
        // On the axis, aslant by the square of the cosine; the surface has given way a little.
        EXPECT_NEAR(hand.state.irrigation.placode_pa /
                        jet_pressure_pa(scene->irrigation->jet, away, 0, std::cos(tilt)),
                    1, 0.02)
            << tilt;
        hand.hold(Vec3(0, 0, 0.02), 0, 0, 1);
        EXPECT_EQ(hand.load().norm(), 0);
    }
}

TEST(Jet, PushesTissueInAndLetsItComeBack) {
    const auto& scene = level_scene();
    Hand hand(*scene);
    hand.hold(Vec3(0, 0, 0.005), 0, kPedalCut, 200);
    const RayHit pressed = first_hit(hand.state, Vec3(0, 0, 0.005), -Vec3::UnitZ(), 0.02);
    ASSERT_GE(pressed.triangle, 0);
    EXPECT_GT(pressed.distance_m, 0.005 + 2e-6);
    hand.hold(Vec3(0, 0, 0.005), 0, 0, 600);
    const RayHit back = first_hit(hand.state, Vec3(0, 0, 0.005), -Vec3::UnitZ(), 0.02);
    EXPECT_LT(back.distance_m - 0.005, 0.2 * (pressed.distance_m - 0.005));
    // From behind, nothing of the surface is in the way but the underside.
    const RayHit below = first_hit(hand.state, Vec3(0, 0, -0.02), Vec3::UnitZ(), 0.05);
    ASSERT_GE(below.triangle, 0);
    EXPECT_LT(below.distance_m, 0.0195);
    EXPECT_LT(first_hit(hand.state, Vec3(0.1, 0, 0.01), -Vec3::UnitZ(), 0.02).triangle, 0);
}

/// A bowl z = a r^2 of 24 mm.
PoolGrid bowl(double a) {
    PoolGrid grid;
    grid.columns = grid.rows = 48;
    grid.x_m = grid.y_m = -0.012;
    for (int32_t c = 0; c < 48 * 48; ++c) {
        grid.ground_m.push_back(static_cast<float>(a * grid.middle(c).squaredNorm()));
        const int i = c % 48, j = c / 48;
        grid.drain.push_back(i == 0 || j == 0 || i == 47 || j == 47 ? 1 : 0);
    }
    return grid;
}

Pool empty(const PoolGrid& grid) {
    Pool pool;
    pool.volume_m3.assign(grid.cells(), 0);
    pool.blood_m3 = pool.volume_m3;
    return pool;
}

TEST(Pool, FindsTheLevelOfABowlAndKeepsItsVolume) {
    const double a = 20, volume = 2e-7;
    const PoolGrid grid = bowl(a);
    Pool pool = empty(grid);
    PoolFlux flux(grid.cells());
    // All of it in one place beside the middle, a tenth of it blood.
    add_fluid(pool, grid.cell_at(0.004, 0.001), volume, 0.1 * volume);
    for (int i = 0; i < 6000; ++i) sweep_pool(grid, pool, flux);
    EXPECT_NEAR(stored_m3(pool) / volume, 1, 1e-12);
    double blood = 0, low = 1, high = -1;
    for (int32_t c = 0; c < static_cast<int32_t>(grid.cells()); ++c) {
        blood += pool.blood_m3[static_cast<size_t>(c)];
        if (pool_depth_m(grid, pool, c) < 1e-4) continue;
        low = std::min(low, pool_level_m(grid, pool, c));
        high = std::max(high, pool_level_m(grid, pool, c));
    }
    EXPECT_NEAR(blood / (0.1 * volume), 1, 1e-12);
    EXPECT_LT(high - low, 1e-6);
    // V = pi L^2 / (2 a); film and cells make the rest.
    EXPECT_NEAR(low / std::sqrt(2 * a * volume / kPi), 1, 0.03);
}

TEST(Pool, WhatIsGivenStandsRunsOffOrIsSucked) {
    const PoolGrid grid = bowl(5);
    Pool pool = empty(grid);
    PoolFlux flux(grid.cells());
    for (int i = 0; i < 4000; ++i) {
        add_fluid(pool, grid.cell_at(0.003, 0), 1e-9, 1e-11);
        sweep_pool(grid, pool, flux);
        if (i > 2000) (void)drain_pool(grid, pool, Vec2(-0.002, 0), 0.002, 0, 2e-10);
    }
    add_fluid(pool, -1, 1e-9, 0);
    EXPECT_GT(pool.run_off_m3, 1e-8) << "the bowl is full";
    EXPECT_GT(pool.sucked_m3, 3e-7);
    EXPECT_NEAR((stored_m3(pool) + pool.run_off_m3 + pool.sucked_m3) / pool.given_m3, 1, 1e-12);
    for (const double v : pool.volume_m3) EXPECT_GE(v, 0);
    for (const double v : pool.blood_m3) EXPECT_GE(v, 0);
    // Sucked without end it is dry down to its film.
    for (int i = 0; i < 20000; ++i) {
        (void)drain_pool(grid, pool, Vec2(0, 0), 0.002, -1, 1e-8);
        sweep_pool(grid, pool, flux);
    }
    EXPECT_EQ(standing_m3(grid, pool), 0);
    // Nothing is drunk from below the mouth's reach.
    EXPECT_EQ(drain_pool(grid, pool, Vec2(0, 0), 0.002, 0.01, 1e-8), 0);
}

TEST(Pool, BloodHidesByBeerAndLambert) {
    Irrigation irrigation;
    irrigation.grid = bowl(5);
    Pool pool = empty(irrigation.grid);
    irrigation.view = {irrigation.grid.cell_at(0, 0), irrigation.grid.cell_at(0.002, 0)};
    const double thick = 2e-5;  // a depth of blood [m]
    add_fluid(pool, irrigation.view[0], 1e-9, thick * irrigation.grid.cell_m2());
    EXPECT_NEAR(cell_hidden(irrigation.grid, pool, irrigation.view[0]), 1 - std::exp(-0.6), 1e-12);
    EXPECT_NEAR(view_hidden(irrigation, pool), 0.5 * (1 - std::exp(-0.6)), 1e-12);
}

TEST(Suction, PullsWithPressureTimesMouthWhereTissueIsNearAndNotElsewhere) {
    const auto& scene = level_scene();
    const SuctionSpec& spec = scene->irrigation->suction;
    const double mouth = spec.pressure_pa * kPi / 4 * spec.bore_m * spec.bore_m;
    Hand hand(*scene);
    hand.hold(Vec3(0, 0, 0.0015), 0, kPedalCoag, 5);
    EXPECT_EQ(hand.load().norm(), 0) << "twice as far as the mouth's radius";
    hand.hold(Vec3(0, 0, 0.0004), 0, kPedalCoag, 400);
    const double near = 1 - hand.state.tools[0].tip_gap_m / (spec.bore_m / 2);
    hand.hold(Vec3(0, 0, 0.0004), 0, kPedalCoag, 1);
    EXPECT_GT(near, 0.4);
    EXPECT_NEAR(hand.load().z() / (mouth * near * near), 1, 0.02);
    // Held for a while: an event, on the placode.
    hand.hold(Vec3(0, 0, 0.0002), 0, kPedalCoag, 200);
    hand.hold(Vec3(0, 0, 0.02), 0, 0, 10);
    const auto events = irrigation_events(*scene, hand.state);
    bool held = false;
    for (const Event& e : events)
        held = held || (e.kind == EventKind::kSuctionHeld && e.tissue == Tissue::kPlacode &&
                        e.value > 0.1F && e.value2 < static_cast<float>(1.001 * mouth));
    EXPECT_TRUE(held);
}

TEST(Debris, IsLoosenedByMoreShearThanItStandsForLongEnough) {
    OperativeFieldSpec spec = level_pad();
    spec.irrigation->crumbs = 1;
    spec.irrigation->law.adhesion_pa = {10, 10};
    const auto scene = build_operative_field(spec);
    Hand hand(*scene);
    const Vec3 crumb = debris_place(*scene, hand.state, 0);
    const double width = jet_width_m(scene->irrigation->jet, 0.03);
    // From 30 mm there is no more than 1.25 Pa.
    hand.hold(crumb + Vec3(width, 0, 0.03), 0, kPedalCut, 600);
    EXPECT_EQ(hand.state.irrigation.debris[0].fate, DebrisFate::kStuck);
    // From 8 mm there are 17 Pa beside the axis, and none on it.
    hand.hold(crumb + Vec3(0, 0, 0.008), 0, kPedalCut, 600);
    EXPECT_EQ(hand.state.irrigation.debris[0].fate, DebrisFate::kStuck);
    hand.hold(crumb + Vec3(0.0009, 0, 0.008), 0, kPedalCut, 250);
    EXPECT_EQ(hand.state.irrigation.debris[0].fate, DebrisFate::kStuck);
    hand.hold(crumb + Vec3(0.0009, 0, 0.008), 0, kPedalCut, 100);
    EXPECT_NE(hand.state.irrigation.debris[0].fate, DebrisFate::kStuck);
}

/// Washes, sucks, comes too near, on this number of threads.
uint64_t washed(const Scene& scene, int threads) {
    Hand hand(scene, threads);
    hand.hold(Vec3(0.001, 0, 0.007), 0.4, kPedalCut, 150);
    hand.hold(Vec3(-0.001, 0.001, 0.0006), 0, kPedalCoag, 100);
    hand.hold(Vec3(0, 0, 0.0001), 0, kPedalCut | kPedalCoag, 100);
    return state_hash(hand.state);
}

TEST(Irrigation, IsTheSameOnAnyNumberOfThreads) {
    const auto& scene = soiled_scene();
    const uint64_t one = washed(*scene, 1);
    EXPECT_EQ(washed(*scene, 2), one);
    EXPECT_EQ(washed(*scene, 3), one);
}

TEST(Irrigation, GoesOnFromASavedState) {
    const auto& scene = soiled_scene();
    Hand straight(*scene);
    straight.hold(Vec3(0.001, 0, 0.007), 0.4, kPedalCut, 120);
    Hand again(*scene);
    load_own_state(again.state, save_state(*scene, straight.state));
    EXPECT_EQ(state_hash(again.state), state_hash(straight.state));
    for (Hand* hand : {&straight, &again}) hand->hold(Vec3(0, 0, 0.0004), 0, kPedalCoag, 80);
    EXPECT_EQ(state_hash(again.state), state_hash(straight.state));
}

TEST(Irrigation, CostsNothingAndSaysNothingWhereThereIsNone) {
    OperativeFieldSpec spec = level_pad();
    spec.irrigation.reset();
    spec.tools[0].kind = ToolKind::kProbe;
    const auto scene = build_operative_field(spec);
    Hand hand(*scene);
    hand.hold(Vec3(0, 0, 0.003), 0, kPedalCut | kPedalCoag, 5);
    EXPECT_TRUE(hand.state.irrigation.pool.volume_m3.empty());
    EXPECT_TRUE(irrigation_events(*scene, hand.state).empty());
}

/// Words of the refusal of a field.
template <class Change>
std::string refusal(const Change& change) {
    OperativeFieldSpec spec = level_pad();
    change(spec);
    try {
        (void)build_operative_field(spec);
        return "accepted";
    } catch (const MeshError& error) {
        return error.what();
    }
}

TEST(Irrigation, RefusesWhatItCannotBeTogetherWith) {
    using ::testing::HasSubstr;
    EXPECT_THAT(refusal([](OperativeFieldSpec& s) { s.heat = true; }),
                HasSubstr("irrigation: it does not know heat"));
    EXPECT_THAT(refusal([](OperativeFieldSpec& s) { s.irrigation.reset(); }),
                HasSubstr("an irrigator without fluid"));
    EXPECT_THAT(refusal([](OperativeFieldSpec& s) { s.irrigation->jet.speed_m_s = 20; }),
                HasSubstr("irrigation.jet_speed_m_s = 20, allowed 0.01 to 10"));
    EXPECT_THAT(refusal([](OperativeFieldSpec& s) { s.irrigation->law.hold_s[1] = -1; }),
                HasSubstr("irrigation.spot_s = -1, allowed 0 to 60"));
}

}  // namespace THIS_TEST
}  // namespace placode::sim

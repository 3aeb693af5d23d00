// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Over-stretch as volume x time, and how far heat went beyond the incision: against sums and places
// that follow from the numbers put in.

#include "sim/ledger/damage.h"
#include "sim/ledger/ledger.h"
#include "sim/world/add_event.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/cutting/cutting.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kVolume = 2e-10;

double skin_sum(OverStretch& stretch) { return stretch.take()[0].volume_time_m3_s; }

/// A spell of one tet, checked every `every` frames.
double spell(int64_t frames, int64_t every = 1) {
    OverStretch stretch(1, 1e-3);
    for (int64_t f = 100; f <= 100 + frames; f += every)
        stretch.beyond(0, f, 1.4, kVolume, Tissue::kSkin);
    return skin_sum(stretch);
}

TEST(OverStretch, ASpellCountsWholeWhenItIsLongerThanFiftyMilliseconds) {
    EXPECT_EQ(spell(0), 0);
    EXPECT_EQ(spell(50), 0);
    EXPECT_NEAR(spell(51), kVolume * 0.051, 1e-9 * kVolume);
    EXPECT_NEAR(spell(400), kVolume * 0.4, 1e-9 * kVolume);
    // Away from instruments: a check every 64 frames.
    EXPECT_NEAR(spell(128, 64), kVolume * 0.128, 1e-9 * kVolume);
}

TEST(OverStretch, ReliefEndsASpellAndTakingEmptiesTheSum) {
    OverStretch stretch(2, 1e-3);
    for (int64_t f = 0; f <= 80; ++f) {
        if (f == 40) stretch.below(0);
        if (f != 40) stretch.beyond(0, f, 1.9, kVolume, Tissue::kSkin);
        stretch.beyond(1, f, f == 70 ? 1.5 : 1.3, kVolume, Tissue::kZone);
    }
    const auto sums = stretch.take();
    EXPECT_EQ(sums[0].volume_time_m3_s, 0);  // 39 ms and 39 ms
    EXPECT_EQ(sums[0].stretch, 0);
    const OverStretch::Sum& zone = sums[static_cast<size_t>(Tissue::kZone)];
    EXPECT_NEAR(zone.volume_time_m3_s, kVolume * 0.08, 1e-9 * kVolume);
    EXPECT_EQ(zone.stretch, 1.5);
    EXPECT_EQ(zone.tet, 1);
    stretch.beyond(1, 90, 1.3, kVolume, Tissue::kZone);
    EXPECT_NEAR(stretch.take()[static_cast<size_t>(Tissue::kZone)].volume_time_m3_s, kVolume * 0.01,
                1e-9 * kVolume);
}

/// Deforms a whole block by `f`, holds it for 200 frames of checks, returns the sums.
Event held(const Mat3& f, double injury_stretch) {
    test::BoxOptions options;
    options.cells = {6, 6, 4};
    options.sleep = false;
    options.material.injury_stretch = injury_stretch;
    options.material.fail_stretch = 3;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
        const Vec3 x = f * scene.body.mesh().rest[v];
        state.body.x[v].x = static_cast<float>(x.x());
        state.body.x[v].y = static_cast<float>(x.y());
        state.body.x[v].z = static_cast<float>(x.z());
    }
    for (int i = 0; i < 200; ++i) {
        ++state.frame;
        tear(scene, state);
    }
    state.event_count = 0;
    ledger_stretch(scene, state);
    return state.event_count > 0 ? state.events[0] : Event{};
}

TEST(OverStretch, ASimpleShearOfTwoFifthsIsSummedWithItsStretch) {
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = 0.4;
    const Event sum = held(shear, 1.2);
    EXPECT_EQ(sum.kind, EventKind::kStretchSum);
    // sigma_max of [[1, 0.4], [0, 1]] = 0.2 + sqrt(1.04); floats.
    EXPECT_NEAR(sum.value2, 0.2 + std::sqrt(1.04), 1e-4);
    // 200 frames hold three or four checks, 64 frames apart, of every tet: 128 to 192 ms of it.
    const double volume = 0.008 * 0.008 * 0.003;
    EXPECT_GT(sum.value, volume * 0.127);
    EXPECT_LT(sum.value, volume * 0.193);
    EXPECT_EQ(held(shear, 1.25).kind, EventKind::kPhase);  // below the limit: no event
}

TEST(OverStretch, ARotationStretchesNothing) {
    const Mat3 turned = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    EXPECT_EQ(held(turned, 1.0001).kind, EventKind::kPhase);
}

TEST(OverStretch, TissueAsleepStaysStretched) {
    const Scene scene = test::box_scene({});
    State state(scene, 1);
    OverStretch stretch(scene.body.tet_count(), 1e-3);
    stretch.beyond(7, 1, 1.4, kVolume, Tissue::kSkin);
    state.frame = 501;
    std::fill(state.sleep.vertex_asleep.begin(), state.sleep.vertex_asleep.end(), uint8_t{0});
    stretch.catch_up(scene, state);
    EXPECT_EQ(skin_sum(stretch), 0);  // awake: only checks count
    std::fill(state.sleep.vertex_asleep.begin(), state.sleep.vertex_asleep.end(), uint8_t{1});
    stretch.catch_up(scene, state);
    const double volume = static_cast<double>(scene.body.volume_m3()[7]);
    EXPECT_NEAR(skin_sum(stretch), volume * 0.5, 1e-9 * volume);
}

constexpr double kHalf = 0.002, kKerf = 0.00025;  // the plan is a square; its kerf to either side

double from_plan(const Vec3& p) {
    return std::abs(std::max(std::abs(p.x()), std::abs(p.y())) - kHalf);
}

/// A block with a square to cut, in a lattice of 0.25 mm whose lines are the edges of the kerf.
Scene square_scene() {
    test::BoxOptions options;
    options.size_m = Vec3(0.008, 0.008, 0.001);
    options.cells = {32, 32, 4};
    Scene scene = test::box_scene(options);
    constexpr int kSide = 16;
    const Vec3 corner[]{
        {-kHalf, -kHalf, 0}, {kHalf, -kHalf, 0}, {kHalf, kHalf, 0}, {-kHalf, kHalf, 0}};
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < kSide; ++i)
            scene.geometry.planned_contour.push_back(
                corner[side] + (corner[(side + 1) % 4] - corner[side]) * i / kSide);
    }
    return scene;
}

void cut_square(const Scene& scene, State& state, EventKind cause) {
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        state.event_count = 0;
        if (from_plan(rest_centroid(scene, t)) < kKerf) remove_tissue(scene, state, t, cause, 0, 0);
    }
}

/// ln Omega and ln CEM43 fall straight from the plan: Omega = 1 at 0.9 mm, CEM43 = 240 at 1.2 mm.
void burn_square(const Scene& scene, State& state) {
    HeatState& heat = state.heat[0];
    for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
        const double d = from_plan(scene.body.mesh().rest[v]);
        heat.arrhenius[v] = static_cast<float>(std::min(10.0, std::exp((0.0009 - d) / 0.0002)));
        heat.cem43_min[v] = static_cast<float>(240 * std::exp((0.0012 - d) / 0.0001));
    }
}

TEST(ThermalSpread, IsMeasuredFromTheEdgeOfTheKerfToTheIsoLines) {
    const Scene scene = square_scene();
    State state(scene, 1);
    EXPECT_TRUE(thermal_spread(scene, state).empty());
    cut_square(scene, state, EventKind::kVaporised);
    burn_square(scene, state);
    int inner = 0, outer = 0;
    for (const SpreadRay& ray : thermal_spread(scene, state)) {
        // Nearer to a corner an inward ray meets the burn of the next side.
        if (ray.point % 16 < 5 || ray.point % 16 > 11) continue;
        ++(ray.outward ? outer : inner);
        const double reach = std::max(std::abs(ray.edge_m.x()), std::abs(ray.edge_m.y()));
        // Half a step of a ray (0.02 mm).
        EXPECT_NEAR(reach, kHalf + (ray.outward ? kKerf : -kKerf), 1.1e-5);
        EXPECT_NEAR(std::abs(reach - kHalf) + ray.damage_m, 0.0009, 2e-6) << ray.point;
        EXPECT_NEAR(std::abs(reach - kHalf) + ray.dose_m, 0.0012, 2e-6) << ray.point;
    }
    EXPECT_EQ(inner, 28);
    EXPECT_EQ(outer, 28);
}

TEST(ThermalSpread, TornTissueIsNoIncisionAndAColdOneHasNoSpread) {
    const Scene scene = square_scene();
    State torn(scene, 1);
    cut_square(scene, torn, EventKind::kTorn);
    burn_square(scene, torn);
    EXPECT_TRUE(thermal_spread(scene, torn).empty());
    State cold(scene, 1);
    cut_square(scene, cold, EventKind::kVaporised);
    const auto rays = thermal_spread(scene, cold);
    EXPECT_EQ(rays.size(), 128u);
    for (const SpreadRay& ray : rays) {
        EXPECT_EQ(ray.damage_m, 0);
        EXPECT_EQ(ray.dose_m, 0);
    }
}

TEST(ThermalSpread, ARayEndsWithTheTissue) {
    const Scene scene = square_scene();
    State state(scene, 1);
    cut_square(scene, state, EventKind::kVaporised);
    std::fill(state.heat[0].cem43_min.begin(), state.heat[0].cem43_min.end(), 1e9f);
    for (const SpreadRay& ray : thermal_spread(scene, state)) {
        if (ray.point % 16 < 4 || ray.point % 16 > 12 || !ray.outward) continue;
        EXPECT_NEAR(ray.dose_m, 0.004 - kHalf - kKerf, 4e-5);
    }
}

TEST(ThermalSpread, DamageBeyondTheFrozenTenIsThatOfOneSecond) {
    const Scene scene = square_scene();
    const HeatSettings& heat = scene.heat->settings();
    EXPECT_EQ(continued_damage(scene, 3, 1e9), 3);
    for (const double celsius : {75.0, 85.0, 100.0}) {
        const double damage =
            arrhenius_rate(heat.arrhenius_a_per_s, heat.arrhenius_ea_j_mol, celsius);
        EXPECT_NEAR(continued_damage(scene, 10, cem43_rate(celsius) / 60), damage, 1e-9 * damage);
    }
    // Never below what is known, whatever the dose.
    EXPECT_EQ(continued_damage(scene, 10, 0), 10);
    EXPECT_TRUE(std::isfinite(continued_damage(scene, 10, INFINITY)));
}

TEST(ClosingEvents, BeginWithTheNumberOfRays) {
    const Scene scene = square_scene();
    State state(scene, 1);
    cut_square(scene, state, EventKind::kVaporised);
    const uint64_t before = state_hash(state);
    const auto events = closing_events(scene, state);
    EXPECT_EQ(state_hash(state), before);
    ASSERT_EQ(events.size(), 129u);
    EXPECT_EQ(events[0].kind, EventKind::kThermalSpread);
    EXPECT_EQ(events[0].element, -1);
    EXPECT_EQ(events[0].value, 128);
    EXPECT_EQ(events[1].element, 0);
    EXPECT_EQ(events[2].element, 1);
    EXPECT_TRUE(only_in_recording(events[0].kind));
}

/// Whoever ends the attempt with the foot on the pedal has burned all the same.
TEST(ClosingEvents, TellWhatIsStillGoingOn) {
    const Scene scene = square_scene();
    State state(scene, 1);
    EXPECT_TRUE(open_spells(scene, state).empty());
    ToolLedger& spell = state.ledger.tools[0];
    spell.contact_s = 0.2F;
    spell.peak_force_n = 0.03F;
    spell.over_force_s = 60;
    spell.over_force_peak_n = 0.6F;
    spell.dwell_s = 3;
    spell.air_s = 0.9F;  // too short to count
    spell.placode_energised_s = 0.4F;
    spell.energised_peak_c = 80;
    state.grasps[0].traction_s = 5;
    state.grasps[0].traction_peak_n = 1;
    const uint64_t before = state_hash(state);
    const auto events = closing_events(scene, state);
    EXPECT_EQ(state_hash(state), before);
    const auto expect = [&](EventKind kind, float value, float value2) {
        const auto found = std::find_if(events.begin(), events.end(),
                                        [&](const Event& e) { return e.kind == kind; });
        ASSERT_NE(found, events.end()) << event_name(kind);
        EXPECT_EQ(found->value, value) << event_name(kind);
        EXPECT_EQ(found->value2, value2) << event_name(kind);
        EXPECT_EQ(found->tool, 0) << event_name(kind);
        EXPECT_EQ(found->time_s, state.time_s) << event_name(kind);
    };
    expect(EventKind::kPlacodeContact, 0.2F, 0.03F);
    expect(EventKind::kOverForce, 60, 0.6F);
    expect(EventKind::kDwell, 3, 0);
    expect(EventKind::kPlacodeEnergised, 0.4F, 80);
    expect(EventKind::kOverTraction, 5, 1);
    for (const Event& e : events) EXPECT_NE(e.kind, EventKind::kEnergyInAir);
    // Too short to be a way of working, as while it runs.
    spell.over_force_s = 0.04F;
    for (const Event& e : open_spells(scene, state)) EXPECT_NE(e.kind, EventKind::kOverForce);
}

}  // namespace THIS_TEST
}  // namespace placode::sim

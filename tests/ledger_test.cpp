// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace placode::assessment {
namespace THIS_TEST {

using sim::Event;
using sim::EventKind;
using sim::Tissue;
using sim::Vec3;

std::vector<Vec3> circle(double radius_m) {
    std::vector<Vec3> line;
    for (int i = 0; i < 72; ++i) {
        const double a = 2 * std::numbers::pi * i / 72;
        line.emplace_back(radius_m * std::cos(a), radius_m * std::sin(a), 0);
    }
    return line;
}

/// Placode to 4 mm, skin from 8 mm on.
sim::FieldGeometry field() {
    sim::FieldGeometry geometry;
    geometry.placode_edge = circle(0.004);
    geometry.planned_contour = circle(0.0055);
    geometry.skin_edge = circle(0.008);
    return geometry;
}

Event event(EventKind kind, double time_s, float value, float x, float y,
            Tissue tissue = Tissue::kZone) {
    Event one;
    one.kind = kind;
    one.time_s = time_s;
    one.value = value;
    one.tissue = tissue;
    one.rest_position_m = {x, y, 0};
    return one;
}

TEST(Ledger, APlacodeContactStandsWhereAndWhenItLasted) {
    const std::vector<Event> events{event(EventKind::kPlacodeContact, 10, 3, 0.003F, 0)};
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].lane, HarmLane::kPlacode);
    EXPECT_DOUBLE_EQ(entries[0].from_s, 7);  // raised at its end
    EXPECT_DOUBLE_EQ(entries[0].to_s, 10);
    EXPECT_EQ(entries[0].hour, 12);  // cranial
    EXPECT_EQ(entries[0].region, Region::kPlacode);
    EXPECT_FALSE(entries[0].critical);
}

TEST(Ledger, ADroppedNeedleStandsWhereItWasLetGo) {
    Event dropped = event(EventKind::kNeedleDropped, 12, 6, 0.010F, 0);
    dropped.value2 = 0.008F;
    const auto entries = damage_ledger(std::vector<Event>{dropped}, field());
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].kind, EventKind::kNeedleDropped);
    EXPECT_EQ(entries[0].lane, HarmLane::kForce);
    EXPECT_DOUBLE_EQ(entries[0].from_s, 12) << "its first value is a step and no duration";
    EXPECT_DOUBLE_EQ(entries[0].to_s, 12);
    EXPECT_FLOAT_EQ(static_cast<float>(entries[0].value2), 0.008F);
    EXPECT_EQ(entries[0].hour, 12);
    EXPECT_FALSE(entries[0].critical);
}

TEST(Ledger, CuttingTheZoneIsTheTaskAndNoDamage) {
    std::vector<Event> events{event(EventKind::kVaporised, 1, 1e-10F, 0, 0.0055F),
                              event(EventKind::kSnipped, 1.2, 1e-6F, 0, 0.0055F)};
    EXPECT_TRUE(damage_ledger(events, field()).empty());
    // Half a millimetre into the skin is within the band, two are not.
    events = {event(EventKind::kVaporised, 1, 1e-10F, 0, -0.0085F, Tissue::kSkin)};
    EXPECT_TRUE(damage_ledger(events, field()).empty());
    events = {event(EventKind::kVaporised, 1, 1e-10F, 0, -0.0100F, Tissue::kSkin)};
    ASSERT_EQ(damage_ledger(events, field()).size(), 1U);
    EXPECT_EQ(damage_ledger(events, field())[0].hour, 3);  // the patient's right
    EXPECT_EQ(damage_ledger(events, field())[0].region, Region::kSkin);
}

TEST(Ledger, TornTissueIsDamageInEveryTissue) {
    const std::vector<Event> events{event(EventKind::kTorn, 1, 1e-10F, 0, 0.0055F),
                                    event(EventKind::kTorn, 1.1, 2e-10F, 0, 0.0056F),
                                    event(EventKind::kTorn, 5, 1e-10F, 0, 0.003F, Tissue::kPlacode),
                                    event(EventKind::kTorn, 9, 1e-10F, 0, 0.01F, Tissue::kSkin)};
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[0].lane, HarmLane::kTissue);
    EXPECT_EQ(entries[0].region, Region::kZone);
    EXPECT_FALSE(entries[0].critical) << "of the tissue that is cut anyway";
    EXPECT_NEAR(entries[0].value, 3e-10, 1e-15);
    EXPECT_TRUE(entries[1].critical);
    EXPECT_EQ(entries[2].region, Region::kSkin);
}

TEST(Ledger, ElementsOfOneHarmAreOneEntryWithTheSumOfTheirVolumes) {
    std::vector<Event> events;
    for (int i = 0; i < 5; ++i)
        events.push_back(
            event(EventKind::kVaporised, 2 + 0.1 * i, 2e-10F, 0.001F, 0.001F, Tissue::kPlacode));
    events.push_back(event(EventKind::kVaporised, 9, 2e-10F, 0.001F, 0.001F, Tissue::kPlacode));
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].count, 5);
    EXPECT_NEAR(entries[0].value, 1e-9, 1e-15);
    EXPECT_TRUE(entries[0].critical);
    EXPECT_EQ(entries[0].lane, HarmLane::kPlacode);
    EXPECT_NEAR(entries[0].to_s, 2.4, 1e-9);
    EXPECT_DOUBLE_EQ(entries[1].from_s, 9);
}

TEST(Ledger, EnergyInTheAirHasNoPlace) {
    const std::vector<Event> events{event(EventKind::kEnergyInAir, 5, 2, 0.002F, 0.002F)};
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_FALSE(entries[0].has_place);
    EXPECT_EQ(entries[0].hour, 0);
}

TEST(Ledger, ABuriedTipIsHarmToTheTissueWhereItWas) {
    Event buried = event(EventKind::kBuried, 9, 2, 0, -0.006F);
    buried.value2 = 0.0015F;
    const auto entries = damage_ledger(std::vector{buried}, field());
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].lane, HarmLane::kTissue);
    EXPECT_DOUBLE_EQ(entries[0].from_s, 7);
    EXPECT_EQ(entries[0].hour, 3);
    EXPECT_FLOAT_EQ(static_cast<float>(entries[0].value2), 0.0015F);
}

TEST(Ledger, NeedleAndThreadHaveTheirPlaces) {
    const std::vector<Event> events{
        event(EventKind::kNeedleTurned, 4, 0.5F, 0.009F, 0, Tissue::kSkin),
        event(EventKind::kThreadCut, 6, 650, 0, 0.009F, Tissue::kSkin),
        event(EventKind::kNeedleEntered, 7, 0.06F, 0.009F, 0, Tissue::kSkin),
        event(EventKind::kThreadToreOut, 8, 650, 0, 0.009F, Tissue::kSkin)};
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 3U) << "a bite is no harm";
    EXPECT_EQ(entries[0].lane, HarmLane::kForce);
    EXPECT_DOUBLE_EQ(entries[0].from_s, 3.5);
    EXPECT_EQ(entries[1].lane, HarmLane::kTissue);
    EXPECT_EQ(entries[1].hour, 9);  // left
    EXPECT_EQ(entries[1].region, Region::kSkin);
    EXPECT_EQ(entries[2].kind, EventKind::kThreadToreOut);
}

TEST(Ledger, EntriesAreInOrderOfTimeWhenTheyBegan) {
    const std::vector<Event> events{event(EventKind::kDwell, 8, 1, 0.005F, 0),
                                    event(EventKind::kOverForce, 9, 7, 0.005F, 0)};
    const auto entries = damage_ledger(events, field());
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].kind, EventKind::kOverForce);  // from 2 s on
}

TEST(Ledger, PhasesBeginWithInspectAndChangeOnce) {
    std::vector<Event> events{event(EventKind::kPhase, 3, 1, 0, 0),
                              event(EventKind::kPhase, 4, 1, 0, 0),
                              event(EventKind::kPhase, 9, 4, 0, 0)};
    const auto phases = phase_starts(events);
    ASSERT_EQ(phases.size(), 3U);
    EXPECT_EQ(phases[0].phase, sim::Phase::kInspect);
    EXPECT_EQ(phases[1].phase, sim::Phase::kIncise);
    EXPECT_DOUBLE_EQ(phases[1].from_s, 3);
    EXPECT_EQ(phases[2].phase, sim::Phase::kCheck);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment

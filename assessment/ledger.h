// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The damage ledger as people read it: what harmed which tissue, from when to when, and where on
// the clock. Made from the events of a recording; many small events of one harm are one entry.

#include <span>
#include <vector>

#include "assessment/metrics.h"
#include "sim/core/geometry.h"

namespace placode::assessment {

/// Lane of the time line that an entry belongs to.
enum class HarmLane : uint8_t { kPlacode, kForce, kTissue, kEnergy };
inline constexpr int kHarmLanes = 4;

/// Part of the field at rest.
enum class Region : uint8_t { kPlacode, kZone, kSkin };
inline constexpr int kRegions = 3;

struct LedgerEntry {
    sim::EventKind kind = sim::EventKind::kDwell;  ///< kVaporised: removed where it must not be.
    HarmLane lane = HarmLane::kTissue;
    bool critical = false;               ///< Harms the placode for good.
    double from_s = 0, to_s = 0;         ///< Equal for what happens at once.
    sim::Vec2 at_m = sim::Vec2::Zero();  ///< At rest; of the first event.
    bool has_place = false;
    int hour = 0;  ///< 1..12, "12 o'clock" is cranial; 0 = no place.
    Region region = Region::kZone;
    double value = 0, value2 = 0;  ///< As of EventKind; volumes and areas are summed [m^3, m^2].
    int count = 1;                 ///< Events in this entry.
};

/// Entries by time. `events` may lack vaporised elements (the store keeps none): then tissue
/// removed in the wrong place is missing, nothing else.
[[nodiscard]] std::vector<LedgerEntry> damage_ledger(std::span<const sim::Event> events,
                                                     const sim::FieldGeometry& geometry);

/// Where a point of the field lies at rest: inside the placode's edge, between it and the skin's
/// edge, or beyond.
[[nodiscard]] Region region_of(const sim::FieldGeometry& geometry, const sim::Vec2& at_m);

/// Phase and when it began [s], by time; the first is kInspect at 0.
struct PhaseStart {
    sim::Phase phase = sim::Phase::kInspect;
    double from_s = 0;
};
[[nodiscard]] std::vector<PhaseStart> phase_starts(std::span<const sim::Event> events);

}  // namespace placode::assessment

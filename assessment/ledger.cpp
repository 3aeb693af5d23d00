// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/ledger.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/scoring.h"
#include "assessment/tissue_metric_parts.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Tissue;

/// Elements lost within this time of each other, in one region, are one harm.
constexpr double kTogetherS = 0.5;

struct KindRule {
    EventKind kind;
    HarmLane lane;
    bool lasts;     ///< value is a duration; the event was raised at its end.
    bool gathered;  ///< One event for each element: summed into one entry.
    bool critical;
};
constexpr KindRule kRules[]{
    {EventKind::kPlacodeContact, HarmLane::kPlacode, true, false, false},
    {EventKind::kPlacodeEnergised, HarmLane::kPlacode, true, false, true},
    {EventKind::kPlacodeOverheated, HarmLane::kPlacode, false, false, false},
    {EventKind::kPlacodeBurned, HarmLane::kPlacode, false, false, true},
    {EventKind::kPlacodeCut, HarmLane::kPlacode, false, true, true},
    {EventKind::kOverForce, HarmLane::kForce, true, false, false},
    {EventKind::kOverTraction, HarmLane::kForce, true, false, false},
    {EventKind::kCrushed, HarmLane::kForce, false, false, false},
    {EventKind::kSlipped, HarmLane::kForce, false, false, false},
    {EventKind::kNeedleSlipped, HarmLane::kForce, true, false, false},
    {EventKind::kNeedleTurned, HarmLane::kForce, true, false, false},
    {EventKind::kNeedleDropped, HarmLane::kForce, false, false, false},
    {EventKind::kThreadCut, HarmLane::kTissue, false, false, false},
    {EventKind::kThreadToreOut, HarmLane::kTissue, false, false, false},
    {EventKind::kBuried, HarmLane::kTissue, true, false, false},
    {EventKind::kTorn, HarmLane::kTissue, false, true, false},
    {EventKind::kVaporised, HarmLane::kTissue, false, true, false},
    {EventKind::kSnipped, HarmLane::kTissue, false, true, false},
    {EventKind::kEnergyInAir, HarmLane::kEnergy, true, false, false},
    {EventKind::kDwell, HarmLane::kEnergy, true, false, false},
};

const KindRule* rule_of(EventKind kind) {
    for (const KindRule& rule : kRules)
        if (rule.kind == kind) return &rule;
    return nullptr;
}

/// Losing an element is harm in the placode and in healthy skin; elsewhere it is the task itself. A
/// tear is harm everywhere: the task asks for none.
class WrongPlace {
 public:
    explicit WrongPlace(const sim::FieldGeometry& geometry) : skin_(geometry) {}
    [[nodiscard]] bool operator()(const Event& event) const {
        if (event.tissue == Tissue::kPlacode || event.kind == EventKind::kTorn) return true;
        if (event.kind == EventKind::kSnipped) return is_skin(event.tissue);
        return skin_.burned(event);
    }

 private:
    HealthySkin skin_;
};

LedgerEntry entry_of(const Event& event, const KindRule& rule, const sim::FieldGeometry& geometry) {
    LedgerEntry entry;
    entry.kind = event.kind;
    entry.lane = rule.lane;
    entry.critical = rule.critical;
    entry.to_s = event.time_s;
    entry.from_s = rule.lasts ? std::max(0.0, event.time_s - event.value) : event.time_s;
    entry.value = event.value;
    entry.value2 = event.value2;
    entry.at_m = Vec2(event.rest_position_m[0], event.rest_position_m[1]);
    // Energy in the air happens nowhere on the tissue.
    entry.has_place = event.kind != EventKind::kEnergyInAir && entry.at_m.allFinite() &&
                      !(entry.at_m.x() == 0 && entry.at_m.y() == 0);
    if (entry.has_place) {
        entry.hour = clock_hour(entry.at_m.x(), entry.at_m.y());
        entry.region = region_of(geometry, entry.at_m);
    }
    // What is said of the placode happened in it, also where its edge has been pushed aside.
    if (rule.lane == HarmLane::kPlacode) entry.region = Region::kPlacode;
    if (rule.gathered && event.tissue == Tissue::kPlacode) {
        entry.region = Region::kPlacode;
        entry.lane = HarmLane::kPlacode;
        entry.critical = true;
    }
    return entry;
}

/// Joins `next` to an entry that it goes on with; false when there is none.
bool gather(std::vector<LedgerEntry>& entries, const LedgerEntry& next) {
    for (auto last = entries.rbegin(); last != entries.rend(); ++last) {
        if (last->kind != next.kind || last->region != next.region || last->lane != next.lane)
            continue;
        if (next.from_s - last->to_s > kTogetherS) return false;
        last->to_s = next.to_s;
        last->value += next.value;
        last->value2 = std::max(last->value2, next.value2);
        ++last->count;
        return true;
    }
    return false;
}

}  // namespace

Region region_of(const sim::FieldGeometry& geometry, const Vec2& at_m) {
    if (geometry.placode_edge.size() >= 3 &&
        ClosedContour(geometry.placode_edge).nearest(at_m).offset < 0)
        return Region::kPlacode;
    if (geometry.skin_edge.size() >= 3 &&
        ClosedContour(geometry.skin_edge).nearest(at_m).offset > 0)
        return Region::kSkin;
    return Region::kZone;
}

std::vector<LedgerEntry> damage_ledger(std::span<const Event> events,
                                       const sim::FieldGeometry& geometry) {
    const WrongPlace wrong(geometry);
    std::vector<LedgerEntry> entries;
    for (const Event& event : events) {
        const KindRule* rule = rule_of(event.kind);
        if (rule == nullptr) continue;
        if (rule->gathered && event.kind != EventKind::kPlacodeCut && !wrong(event)) continue;
        const LedgerEntry entry = entry_of(event, *rule, geometry);
        if (!rule->gathered || !gather(entries, entry)) entries.push_back(entry);
    }
    std::stable_sort(
        entries.begin(), entries.end(),
        [](const LedgerEntry& a, const LedgerEntry& b) { return a.from_s < b.from_s; });
    return entries;
}

std::vector<PhaseStart> phase_starts(std::span<const Event> events) {
    std::vector<PhaseStart> starts{{}};
    for (const Event& event : events) {
        if (event.kind != EventKind::kPhase) continue;
        const auto phase = static_cast<sim::Phase>(std::clamp(std::lround(event.value), 0L, 4L));
        if (phase != starts.back().phase) starts.push_back({phase, event.time_s});
    }
    return starts;
}

}  // namespace placode::assessment

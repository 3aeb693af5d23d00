// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What OverStretch summed up, as events.

#include "sim/cutting/cutting.h"
#include "sim/ledger/damage.h"
#include "sim/ledger/ledger.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {

void ledger_stretch(const Scene& scene, State& state) noexcept {
    OverStretch& stretch = state.ledger.over_stretch;
    stretch.catch_up(scene, state);
    const auto sums = stretch.take();
    for (size_t t = 0; t < sums.size(); ++t) {
        if (!(sums[t].volume_time_m3_s > 0)) continue;
        Event e;
        if (sums[t].tet >= 0) e = tissue_event(scene, state, EventKind::kStretchSum, sums[t].tet);
        e.time_s = state.time_s;
        e.kind = EventKind::kStretchSum;
        e.tissue = static_cast<Tissue>(t);
        e.value = static_cast<float>(sums[t].volume_time_m3_s);
        e.value2 = static_cast<float>(sums[t].stretch);
        add_event(state, e);
    }
}

std::vector<Event> spread_events(const Scene& scene, const State& state) {
    std::vector<Event> events;
    if (state.heat.empty() || scene.geometry.planned_contour.empty()) return events;
    const std::vector<SpreadRay> rays = thermal_spread(scene, state);
    Event e;
    e.time_s = state.time_s;
    e.kind = EventKind::kThermalSpread;
    e.value = static_cast<float>(rays.size());
    events.push_back(e);
    for (const SpreadRay& ray : rays) {
        e.element = 2 * ray.point + (ray.outward ? 1 : 0);
        e.value = static_cast<float>(ray.damage_m);
        e.value2 = static_cast<float>(ray.dose_m);
        for (int k = 0; k < 3; ++k)
            e.rest_position_m[static_cast<size_t>(k)] = static_cast<float>(ray.edge_m[k]);
        events.push_back(e);
    }
    return events;
}

std::vector<Event> closing_events(const Scene& scene, State& state) {
    state.event_count = 0;
    ledger_stretch(scene, state);
    std::vector<Event> events(state.events.begin(), state.events.begin() + state.event_count);
    state.event_count = 0;
    for (const auto& told : {open_spells(scene, state), spread_events(scene, state)})
        events.insert(events.end(), told.begin(), told.end());
    return events;
}

}  // namespace placode::sim

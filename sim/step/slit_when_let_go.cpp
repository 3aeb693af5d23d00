// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/slit_when_let_go.h"

#include "sim/contact/slit_gap.h"
#include "sim/step/let_go.h"
#include "sim/step/watertight.h"
#include "sim/world/scene.h"

namespace placode::sim {

std::vector<Event> slit_when_let_go(const Scene& scene, const State& state) {
    if (!scene.slit.present()) return {};
    const std::unique_ptr<State> after = let_go(scene, state);
    std::vector<Event> events = slit_events(scene, *after);
    const std::vector<Event> leak = watertight_events(scene, *after);
    events.insert(events.end(), leak.begin(), leak.end());
    for (Event& event : events) event.time_s = state.time_s;
    return events;
}

}  // namespace placode::sim

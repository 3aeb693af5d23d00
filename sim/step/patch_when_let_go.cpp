// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/patch_when_let_go.h"

#include "sim/contact/patch_cover.h"
#include "sim/step/let_go.h"
#include "sim/world/scene.h"

namespace placode::sim {

std::vector<Event> patch_when_let_go(const Scene& scene, const State& state) {
    PatchCover cover(scene);
    if (!cover.there()) return {};
    std::vector<Event> events = cover.events(scene, *let_go(scene, state));
    for (Event& event : events) event.time_s = state.time_s;
    return events;
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/add_event.h"

#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

void set_rest_position(Event& e, const Vec3& p) noexcept {
    for (int k = 0; k < 3; ++k) e.rest_position_m[as_index(k)] = static_cast<float>(p[k]);
}

Vec3 rest_centroid(const Scene& scene, int tet) noexcept {
    Vec3 sum = Vec3::Zero();
    for (const int32_t v : scene.body.mesh().tets[tet]) sum += scene.body.mesh().rest[v];
    return sum / 4;
}

void add_event(State& state, const Event& event) noexcept {
    if (state.event_count == kMaxEventsPerFrame) {
        state.flags |= kEventsDropped;
        return;
    }
    state.events[state.event_count++] = event;
}

Event tissue_event(const Scene& scene, const State& state, EventKind kind, int tet) noexcept {
    Event e;
    e.time_s = state.time_s;
    e.kind = kind;
    e.tissue = scene.body.mesh().tissue[tet];
    e.element = tet;
    const Vec3 centre = rest_centroid(scene, tet);
    for (int i = 0; i < 3; ++i) e.rest_position_m[i] = static_cast<float>(centre[i]);
    return e;
}

Event tool_event(const State& state, EventKind kind, int tool) noexcept {
    const ToolState& t = state.tools[tool];
    Event e;
    e.time_s = state.time_s;
    e.kind = kind;
    e.tool = static_cast<int8_t>(tool);
    e.tissue = t.touched;
    e.element = t.spot_tet;
    for (int i = 0; i < 3; ++i) e.rest_position_m[i] = static_cast<float>(t.rest_spot[i]);
    return e;
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/suturing_state.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

Suturing::Suturing(const Scene& scene) {
    if (!scene.suture) return;
    const NeedleStart& start = scene.needle_start;
    needle.emplace_back(*scene.suture, start.X_WN);
    placed = start.in_jaws ? 0 : 1;
}

NeedlePull needle_pull(const Scene& scene, const State& state, int tool) noexcept {
    const Suturing& s = state.suturing;
    const NeedleHold* hold = hold_of(state, tool);
    if (hold == nullptr) return {};
    if (needle_in_the_open(s.needle[0]) && s.handover.second < 0) return {};
    return {-hold->force_n, scene.suture->spec().jaws.pull_n_m};
}

const NeedleHold* hold_of(const State& state, int tool) noexcept {
    const Suturing& s = state.suturing;
    if (s.needle.empty() || tool < 0) return nullptr;
    if (s.driver == tool) return &s.needle[0].hold;
    if (s.handover.second == tool) return &s.needle[0].second.hold;
    return nullptr;
}

bool needle_in_the_open(const SutureState& needle) noexcept {
    return needle.passage_count == 0 && needle.point.mode == PointMode::kFree &&
           needle.thread.channel_count == 0;
}

bool between_hands(const State& state) noexcept {
    return state.suturing.handover.second >= 0 && needle_in_the_open(state.suturing.needle[0]);
}

bool has_two_drivers(const Scene& scene) noexcept {
    return std::count_if(scene.tools.begin(), scene.tools.end(), [](const ToolSpec& tool) {
               return tool.kind == ToolKind::kNeedleDriver;
           }) > 1;
}

Event held_by_both(const State& state, int tool, int32_t element) noexcept {
    const Suturing& s = state.suturing;
    // Turned by an angle, the vector of the quotient has the sine of its half.
    const double half = (s.needle[0].needle.q * s.handover.began.conjugate()).vec().norm();
    Event e = driver_event(state, EventKind::kNeedleHandedOver, tool, static_cast<float>(half),
                           s.handover.apart_n);
    e.element = element;
    return e;
}

Event driver_event(const State& state, EventKind kind, int tool, float value,
                   float value2) noexcept {
    Event e;
    e.time_s = state.time_s;
    e.kind = kind;
    e.tool = static_cast<int8_t>(tool);
    e.value = value;
    e.value2 = value2;
    if (tool >= 0) set_rest_position(e, state.tools[as_index(tool)].proxy.p);
    return e;
}

}  // namespace placode::sim

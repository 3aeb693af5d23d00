// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/undermining_when_let_go.h"

#include "sim/contact/slit_gap.h"
#include "sim/core/as_index.h"
#include "sim/cutting/plane_parting.h"
#include "sim/step/closing_tension.h"
#include "sim/step/let_go.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

Event entry(EventKind kind, int element, double value, double value2) noexcept {
    Event event;
    event.kind = kind;
    event.element = element;
    event.value = static_cast<float>(value);
    event.value2 = static_cast<float>(value2);
    return event;
}

/// Skin of both walls is there: where it was torn away nothing pulls, and nothing can be sewn.
bool can_be_sewn(const Scene& scene, const State& state, size_t station) noexcept {
    const Slit::Station& s = scene.slit.stations[station];
    return is_whole(scene, state, s.left[0]) && is_whole(scene, state, s.right[0]);
}

void add_depths(const Scene& scene, const State& state, std::vector<Event>& events) {
    const auto& rays = scene.plane.rays;
    events.push_back(entry(EventKind::kUndermined, -1, static_cast<double>(rays.size()), 0));
    events.push_back(entry(EventKind::kUndermined, -2, undermined_m2(scene, state, 1),
                           undermined_m2(scene, state, -1)));
    const UnderminedArea left = undermined_area(scene, state, 1),
                         right = undermined_area(scene, state, -1);
    events.push_back(entry(EventKind::kUndermined, -3, left.wanted_m2, right.wanted_m2));
    events.push_back(entry(EventKind::kUndermined, -4, left.freed_m2, right.freed_m2));
    events.push_back(entry(EventKind::kUndermined, -5, left.beyond_m2, right.beyond_m2));
    for (size_t i = 0; i < rays.size(); ++i) {
        const int ray = static_cast<int>(i);
        events.push_back(
            entry(EventKind::kUndermined, ray, undermined_m(scene, state, ray), rays[i].side));
        set_rest_position(events.back(), rays[i].edge_m);
    }
}

}  // namespace

std::vector<Event> undermining_when_let_go(const Scene& scene, const State& state) {
    if (!scene.plane.present()) return {};
    const std::unique_ptr<State> after = let_go(scene, state);
    std::vector<Event> events;
    add_depths(scene, *after, events);
    const size_t stations = scene.slit.stations.size();
    std::vector<bool> whole;
    for (size_t i = 0; i < stations; ++i) whole.push_back(can_be_sewn(scene, *after, i));
    State untouched(scene, state.workers->threads());
    const ClosingTension before = closing_tension(scene, untouched);
    const ClosingTension now = closing_tension(scene, *after);
    const std::vector<double> length_m = station_lengths(scene);
    double sum_n = 0, sum_m = 0;
    for (size_t i = 0; i < stations; ++i) {
        const double n_per_m = whole[i] ? now.at_station[i] : before.at_station[i];
        sum_n += n_per_m * length_m[i];
        sum_m += length_m[i];
        events.push_back(
            entry(EventKind::kClosingTension, static_cast<int>(i), n_per_m, before.at_station[i]));
        set_rest_position(events.back(), middle_at_rest(scene, static_cast<int>(i)));
    }
    events.push_back(
        entry(EventKind::kClosingTension, -1, sum_m > 0 ? sum_n / sum_m : 0, before.n_per_m));
    for (Event& event : events) event.time_s = state.time_s;
    return events;
}

}  // namespace placode::sim

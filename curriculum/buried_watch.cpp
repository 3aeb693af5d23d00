// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/buried_watch.h"

#include <algorithm>

namespace placode::curriculum {

namespace {

constexpr double kEventS = 0.3;  // shorter spells are no event
constexpr double kWarnS = 0.1;   // and shorter ones than this no warning

}  // namespace

std::span<const sim::Event> BuriedWatch::look(const sim::Scene& scene,
                                              const sim::State& state) noexcept {
    event_count_ = 0;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        Spell& spell = spells_[static_cast<size_t>(t)];
        const sim::Burial now = sim::burial_of(scene, state, t);
        if (now.depth_m <= 0) {
            close(t, state.time_s);
            continue;
        }
        if (!spell.open) spell = {true, state.time_s, now};
        if (now.depth_m > spell.deepest.depth_m) spell.deepest = now;
    }
    return {events_.data(), event_count_};
}

std::span<const sim::Event> BuriedWatch::end(double time_s) noexcept {
    event_count_ = 0;
    for (int t = 0; t < static_cast<int>(spells_.size()); ++t) close(t, time_s);
    return {events_.data(), event_count_};
}

void BuriedWatch::close(int tool, double time_s) noexcept {
    Spell& spell = spells_[static_cast<size_t>(tool)];
    const double lasted_s = time_s - spell.since_s;
    if (spell.open && lasted_s > kEventS) {
        sim::Event& event = events_[event_count_++];
        event = {};
        event.time_s = time_s;
        event.kind = sim::EventKind::kBuried;
        event.tool = static_cast<int8_t>(tool);
        event.tissue = spell.deepest.tissue;
        event.value = static_cast<float>(lasted_s);
        event.value2 = static_cast<float>(spell.deepest.depth_m);
        for (int k = 0; k < 3; ++k)
            event.rest_position_m[static_cast<size_t>(k)] =
                static_cast<float>(spell.deepest.rest[k]);
    }
    spell.open = false;
}

bool BuriedWatch::warns(double time_s) const noexcept {
    return std::any_of(spells_.begin(), spells_.end(), [&](const Spell& spell) {
        return spell.open && time_s - spell.since_s >= kWarnS;
    });
}

}  // namespace placode::curriculum

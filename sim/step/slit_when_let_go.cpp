// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/slit_when_let_go.h"

#include <array>
#include <cmath>

#include "sim/contact/slit_gap.h"
#include "sim/step/step.h"
#include "sim/step/watertight.h"
#include "sim/world/saved_state.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

// Tissue that springs back comes to rest in less than 0.2 s.
constexpr double kLetGoS = 0.5;

}  // namespace

std::vector<Event> slit_when_let_go(const Scene& scene, const State& state) {
    if (!scene.slit.present()) return {};
    State after(scene, state.workers->threads());
    load_own_state(after, save_state(scene, state));
    // Those of the moment may be of a frame that never came.
    after.substeps = scene.body.spec().solver.substeps;
    const std::array<ToolInput, kMaxTools> nobody{};
    std::array<ToolFeedback, kMaxTools> feedback{};
    const size_t tools = scene.tools.size();
    const int frames = static_cast<int>(std::ceil(kLetGoS / scene.body.spec().solver.frame_s));
    for (int i = 0; i < frames; ++i)
        (void)step(scene, after, {nobody.data(), tools}, {feedback.data(), tools});
    std::vector<Event> events = slit_events(scene, after);
    const std::vector<Event> leak = watertight_events(scene, after);
    events.insert(events.end(), leak.begin(), leak.end());
    for (Event& event : events) event.time_s = state.time_s;
    return events;
}

}  // namespace placode::sim

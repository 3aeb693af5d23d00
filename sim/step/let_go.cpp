// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/let_go.h"

#include <array>
#include <cmath>

#include "sim/step/step.h"
#include "sim/world/saved_state.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

// Tissue that springs back comes to rest in less than 0.2 s; a patch falls by 2 cm in 0.1 s.
constexpr double kLetGoS = 0.5;

}  // namespace

std::unique_ptr<State> let_go(const Scene& scene, const State& state) {
    auto after = std::make_unique<State>(scene, state.workers->threads());
    load_own_state(*after, save_state(scene, state));
    // Those of the moment may be of a frame that never came.
    after->substeps = scene.body.spec().solver.substeps;
    const std::array<ToolInput, kMaxTools> nobody{};
    std::array<ToolFeedback, kMaxTools> feedback{};
    const size_t tools = scene.tools.size();
    const int frames = static_cast<int>(std::ceil(kLetGoS / scene.body.spec().solver.frame_s));
    for (int i = 0; i < frames; ++i)
        (void)step(scene, *after, {nobody.data(), tools}, {feedback.data(), tools});
    return after;
}

}  // namespace placode::sim

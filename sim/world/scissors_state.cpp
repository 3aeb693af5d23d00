// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/scissors_state.h"

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

bool blades_open(const Scene& scene, const State& state, int tool) noexcept {
    return scene.tools[tool].kind == ToolKind::kScissors &&
           state.scissors[tool].jaw_rad > kBladesOpen;
}

bool blades_in_cut(const Scene& scene, const State& state, int tool) noexcept {
    const Scissors& s = state.scissors[tool];
    if (scene.tools[tool].kind != ToolKind::kScissors) return false;
    // Blades that came in closed are taken for in their gap.
    const bool opened = s.closing || s.start_rad > 0 || s.planned_count == kMetNothing;
    return s.planned_count > 0 || !opened;
}

}  // namespace placode::sim

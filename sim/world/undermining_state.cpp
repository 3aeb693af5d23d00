// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/undermining_state.h"

#include <algorithm>

#include "sim/world/scene.h"

namespace placode::sim {

UnderminingState::UnderminingState(const Scene& scene) : over_count(scene.plane.faces.size(), 0) {
    if (std::any_of(scene.tools.begin(), scene.tools.end(),
                    [](const ToolSpec& tool) { return tool.jaws_spread; }))
        jaws.resize(scene.tools.size());
}

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rim that a cut leaves on the surface, beside the line that the blades took.

#include <array>
#include <vector>

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// Rim of all cuts so far on the surface at rest: places along `ahead` and across it, from the
/// rim's line of best fit [mm], sorted along. Fitted, because tissue had moved a little by the time
/// at which the blades met it.
/// @param tip of the blades [m]. @param ahead where they pointed, a unit vector along the surface.
[[nodiscard]] std::vector<std::array<double, 2>> cut_rim_mm(const Scene& scene, const State& state,
                                                            const Vec3& tip, const Vec3& ahead);

}  // namespace placode::sim

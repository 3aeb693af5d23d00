// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which sectors of the placode no path joins to the skin any more, and where the outline of the
// marked tissue is parted: sim/cutting/pieces.h says how both are asked.

#include "sim/cutting/pieces.h"

namespace placode::sim {

/// Looks at one sector of the placode, if the surface has changed since its last look.
void update_release(const Scene& scene, State& state) noexcept;
/// The same for one point of the outline.
void update_outline(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether surface triangles hang together as when somebody last looked.

#include "sim/world/state.h"

namespace placode::sim {

/// Another number whenever a triangle or a corner of one has changed. A cut parts faces first and
/// their vertices frames later, so SurfaceState::version() alone misses the moment when it opens;
/// both counts only grow.
[[nodiscard]] inline uint32_t shape_version(const State& state) noexcept {
    return state.surface.version() + static_cast<uint32_t>(state.splits);
}

}  // namespace placode::sim

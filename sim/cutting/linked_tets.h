// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The step of every flood over tets that hang together.

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// Calls `visit(other)` for the tets that hang together with `tet` over a face (linked_across() in
/// sim/cutting/cutting.h) and of which `seen(other)` is false. That is asked first: in a flood most
/// neighbours have been reached, and two looks into far memory are saved.
template <class Seen, class Visit>
void for_linked(const Scene& scene, const State& state, int32_t tet, Seen&& seen,
                Visit&& visit) noexcept {
    const auto& neighbours = scene.surface.neighbours()[static_cast<size_t>(tet)];
    for (int f = 0; f < 4; ++f) {
        const int32_t other = neighbours[static_cast<size_t>(f)];
        if (other < 0 || seen(other) || state.surface.on_surface(tet, f) ||
            state.body.tet_alive[static_cast<size_t>(other)] == 0)
            continue;
        visit(other);
    }
}

}  // namespace placode::sim

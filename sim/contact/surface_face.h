// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Faces of the tissue by the tet behind them, which keeps its name while triangles of the surface
// come and go.

#include <algorithm>
#include <array>
#include <cstdint>

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// Which face of a tet has these corners: that opposite to its corner number ...
[[nodiscard]] inline int32_t local_face(const std::array<int32_t, 4>& tet,
                                        const std::array<int32_t, 3>& face) noexcept {
    for (int k = 0; k < 4; ++k) {
        if (std::find(face.begin(), face.end(), tet[static_cast<size_t>(k)]) == face.end())
            return k;
    }
    return 0;
}

/// Its corners, outward by the right-hand rule.
[[nodiscard]] inline std::array<int32_t, 3> corners_of_face(const Scene& scene, const State& state,
                                                            int32_t tet, int32_t face) noexcept {
    const auto& c = corners(scene.body, state.body, tet);
    std::array<int32_t, 3> out{};
    for (size_t k = 0; k < 3; ++k)
        out[k] = c[static_cast<size_t>(kTetFaces[static_cast<size_t>(face)][k])];
    return out;
}

/// False where the tissue has been cut or burned since.
[[nodiscard]] inline bool is_on_surface(const State& state, int32_t tet, int32_t face) noexcept {
    return state.body.tet_alive[static_cast<size_t>(tet)] != 0 &&
           state.surface.on_surface(tet, face);
}

}  // namespace placode::sim

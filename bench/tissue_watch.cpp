// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/tissue_watch.h"

#include <algorithm>
#include <cmath>

namespace placode::bench {

double farthest_tissue(const sim::Scene& scene, const sim::State& state,
                       std::span<const sim::Float4> at_rest) {
    double most = 0;
    const sim::SoftBodyState& body = state.body;
    for (int32_t t = 0; t < scene.body.tet_count(); ++t) {
        const auto at = static_cast<size_t>(t);
        if (body.tet_alive[at] == 0 || state.pieces.of[at] >= 0) continue;
        for (const int32_t v : corners(scene.body, body, t)) {
            // Copies that cuts and tears made began at another vertex's place.
            const auto n = static_cast<size_t>(v);
            if (n >= at_rest.size() || body.free_vertex[n] != 0) continue;
            const double path = (to_vec(body.x[n]) - to_vec(at_rest[n])).norm();
            most = std::isfinite(path) ? std::max(most, path) : 1;
        }
    }
    return most;
}

double fastest_vertex(const sim::State& state) {
    double most = 0;
    const sim::SoftBodyState& body = state.body;
    for (size_t v = 0; v < body.v.size(); ++v) {
        const double speed = to_vec(body.v[v]).norm();
        if (!std::isfinite(speed)) return 1e3;
        if (body.free_vertex[v] == 0) most = std::max(most, speed);
    }
    return most;
}

}  // namespace placode::bench

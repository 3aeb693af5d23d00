// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/cut_rim.h"

#include <algorithm>
#include <set>

namespace placode::sim {

std::vector<std::array<double, 2>> cut_rim_mm(const Scene& scene, const State& state,
                                              const Vec3& tip, const Vec3& ahead) {
    const Vec3 across(-ahead.y(), ahead.x(), 0);
    std::set<int32_t> seen;
    std::vector<std::array<double, 2>> points;
    for (const SurfaceTriangle& t : state.surface.triangles()) {
        if (t.fresh == 0) continue;
        for (const int32_t v : t.vertex) {
            const int32_t origin = origin_of(state.body, v);
            if (scene.field.depth_m[static_cast<size_t>(origin)] > 1e-9F ||
                !seen.insert(origin).second)
                continue;
            const Vec3 p = 1e3 * (rest_place(scene.body, state.body, v) - tip);
            points.push_back({ahead.dot(p), across.dot(p)});
        }
    }
    std::sort(points.begin(), points.end());
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& p : points) {
        n += 1, x += p[0], y += p[1], xx += p[0] * p[0], xy += p[0] * p[1];
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x), offset = (y - slope * x) / n;
    for (auto& p : points) p[1] -= offset + slope * p[0];
    return points;
}

}  // namespace placode::sim

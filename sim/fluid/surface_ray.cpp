// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/fluid/surface_ray.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr double kRayStale = 2e-4;  // boxes may be those of the frame before [m]

/// Whether the line comes into the box, grown a little, before `distance_m`.
bool enters(const SurfaceTree::Box& box, const Vec3& from, const Vec3& along,
            double distance_m) noexcept {
    double near = 0, far = distance_m;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<size_t>(k);
        const double low = static_cast<double>(box.low[i]) - kRayStale - from[k],
                     high = static_cast<double>(box.high[i]) + kRayStale - from[k];
        if (along[k] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / along[k], b = high / along[k];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far;
}

}  // namespace

// Source: Moeller & Trumbore 1997.
RayHit first_hit(const State& state, const Vec3& from, const Vec3& direction,
                 double reach_m) noexcept {
    RayHit best;
    best.distance_m = reach_m;
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            return !enters(box, from, direction, best.distance_m);
        },
        [&](int slot) noexcept {
            const auto& v = state.surface.triangles()[as_index(slot)].vertex;
            const Vec3 a = position(state.body, v[0]), ab = position(state.body, v[1]) - a,
                       ac = position(state.body, v[2]) - a;
            const Vec3 p = direction.cross(ac);
            const double det = ab.dot(p);
            if (!(det > 1e-14)) return;  // seen from behind, or from the edge [m2]
            const Vec3 s = from - a, q = s.cross(ab);
            const double u = s.dot(p) / det, w = direction.dot(q) / det, distance = ac.dot(q) / det;
            if (u < 0 || w < 0 || u + w > 1 || distance < 0 || distance >= best.distance_m) return;
            best.triangle = slot;
            best.distance_m = distance;
            best.weight = Vec3(1 - u - w, u, w);
            best.normal = ab.cross(ac).normalized();
        });
    return best;
}

}  // namespace placode::sim

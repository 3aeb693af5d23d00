// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/tip_gap.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/contact.h"
#include "sim/core/tool_shape.h"
#include "sim/mesh/box_distance.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kTipSearch = 0.003;     // the tip's gap is measured up to here [m]
constexpr double kHintSlack = 1 + 1e-9;  // of a distance squared that was found before
constexpr double kFrameMotion = 0.0005;  // of the tissue in a frame [m]

/// The place of the surface that is next to a point.
struct Nearest {
    int triangle = -1;
    double distance2 = 0;  ///< [m^2]
    Vec3 weight = Vec3::Zero();
};

/// The ball at the end of an instrument.
struct Tip {
    Vec3 centre;
    double radius;
};
Tip tip_of(const State& state, int t) noexcept {
    const double radius = state.scratch->contacts.shapes[t].parts[0].near_radius_m;
    return {state.tools[t].proxy * Vec3(0, 0, -radius), radius};
}

/// Square of the distance of a triangle of the surface to `p` [m^2], and the weights of the point
/// that is next to it.
double distance2_of(const State& state, int triangle, const Vec3& p, Vec3& weight) noexcept {
    Triangle tri;
    for (int k = 0; k < 3; ++k)
        tri[k] = position(state.body, state.surface.triangles()[triangle].vertex[k]);
    weight = closest_on_triangle(p, tri);
    return (p - weight.x() * tri[0] - weight.y() * tri[1] - weight.z() * tri[2]).squaredNorm();
}

/// Of what is nearer than the root of `best`.
Nearest nearest_to(const State& state, const Vec3& centre, double best) noexcept {
    Nearest found;
    found.distance2 = best;
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            // The boxes are those of the start of this frame or of the one before, see
            // collect_candidates(); the tissue has moved a little since.
            return squared_distance(box, centre, 2 * kFrameMotion) >= found.distance2;
        },
        [&](int i) noexcept {
            Vec3 w;
            const double d2 = distance2_of(state, i, centre, w);
            if (d2 < found.distance2) found = {i, d2, w};
        });
    return found;
}

Vec3 place_of(const State& state, const Nearest& nearest) noexcept {
    const SurfaceTriangle& tri = state.surface.triangles()[nearest.triangle];
    const Vec3& w = nearest.weight;
    return w.x() * position(state.body, tri.vertex[0]) +
           w.y() * position(state.body, tri.vertex[1]) +
           w.z() * position(state.body, tri.vertex[2]);
}

double signed_gap(const State& state, const Tip& tip, const Nearest& nearest) noexcept {
    const SurfaceTriangle& tri = state.surface.triangles()[nearest.triangle];
    const Vec3 pa = position(state.body, tri.vertex[0]), pb = position(state.body, tri.vertex[1]),
               pe = position(state.body, tri.vertex[2]);
    const bool inside = (pb - pa).cross(pe - pa).dot(tip.centre - place_of(state, nearest)) < 0;
    const double distance = std::sqrt(nearest.distance2);
    return (inside ? -distance : distance) - tip.radius;
}

}  // namespace

void measure_tips(const Scene& scene, State& state) noexcept {
    const auto triangles = state.surface.triangles();
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        const Tip tip = tip_of(state, t);
        double best = (kTipSearch + tip.radius) * (kTipSearch + tip.radius);
        // No triangle is nearer than the nearest: that of the last frame, or what has its number
        // now, leaves most of the tree out from the start. A little more, for it counts as well.
        int32_t& hint = state.scratch->tip_triangle[t];
        Vec3 weight;
        if (hint >= 0 && hint < std::ssize(triangles))
            best =
                std::min(best, kHintSlack * distance2_of(state, hint, tip.centre, weight) + 1e-18);
        const Nearest nearest = nearest_to(state, tip.centre, best);
        hint = nearest.triangle;
        tool.tip_gap_m = 1;
        if (nearest.triangle < 0) continue;
        tool.tip_gap_m = signed_gap(state, tip, nearest);
        if (tool.bare_gap_m >= 1) {
            const SurfaceTriangle& tri = triangles[nearest.triangle];
            tool.touched = tri.tissue;
            tool.spot = place_of(state, nearest);
            tool.spot_tet = tri.tet;
            tool.rest_spot = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                tool.rest_spot += nearest.weight[k] *
                                  scene.body.mesh().rest[origin_of(state.body, tri.vertex[k])];
            }
        }
    }
}

double tip_gap(const State& state, int t, double search_m) noexcept {
    const Tip tip = tip_of(state, t);
    const double most = std::max(0.0, search_m) + tip.radius;
    const Nearest nearest = nearest_to(state, tip.centre, most * most);
    return nearest.triangle < 0 ? 1 : signed_gap(state, tip, nearest);
}

}  // namespace placode::sim

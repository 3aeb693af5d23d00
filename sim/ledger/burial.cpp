// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/ledger/burial.h"

#include <algorithm>
#include <cmath>

#include "sim/cutting/diathermy.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kLookBackM = 0.040;  // of the shaft behind the tip: no hand reaches deeper
constexpr double kBoxSlackM = 1e-3;   // boxes are those of a frame ago

/// The shaft, or a blade, from a point at the tip towards the hand.
struct ShaftRay {
    Vec3 from, direction;
    double length_m = kLookBackM;

    [[nodiscard]] bool misses(const SurfaceTree::Box& box) const noexcept {
        double first = 0, last = length_m;
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<size_t>(k);
            const double low = static_cast<double>(box.low[axis]) - kBoxSlackM - from[k];
            const double high = static_cast<double>(box.high[axis]) + kBoxSlackM - from[k];
            if (std::abs(direction[k]) < 1e-12) {
                if (low > 0 || high < 0) return true;
                continue;
            }
            const double a = low / direction[k], b = high / direction[k];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        return first > last;
    }
};

struct Crossing {
    double at_m = 0;
    Vec3 normal, weight;
};

/// Where the ray comes out of tissue through this triangle. Source: Moeller and Trumbore 1997.
bool leaves(const ShaftRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
            Crossing& out) noexcept {
    const Vec3 ab = b - a, ac = c - a, area = ab.cross(ac);
    const double facing = area.dot(ray.direction);
    if (!(facing > 0)) return false;
    const Vec3 to = ray.from - a;
    const Vec3 q = to.cross(ray.direction);
    const double v = ac.dot(q) / -facing, w = ab.dot(q) / facing;
    if (v < 0 || w < 0 || v + w > 1) return false;
    out.at_m = -to.dot(area) / facing;
    if (out.at_m < 0 || out.at_m > ray.length_m) return false;
    out.normal = area.normalized();
    out.weight = Vec3(1 - v - w, v, w);
    return true;
}

/// Tissue may stand around it, because it is at work there.
bool at_work(const Scene& scene, const State& state, int t) noexcept {
    const ToolState& tool = state.tools[t];
    const bool cuts = conducts(scene.tools[t].kind) && tool.energised != 0 && tool.coagulating == 0;
    // Jaws that hold nothing but a patch have no tet.
    return cuts || (state.grasps[t].count > 0 && state.grasps[t].tet >= 0);
}

/// Makes `out` that of a deeper crossing of the ray. `before_m`: length of the instrument before
/// the ray's start. Tissue that does not `count` is passed over.
template <class Counts>
void deepest_along(const Scene& scene, const State& state, const ShaftRay& ray, double before_m,
                   Counts&& counts, Burial& out) noexcept {
    const auto triangles = state.surface.triangles();
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept { return ray.misses(box); },
        [&](int i) noexcept {
            const auto& v = triangles[i].vertex;
            Crossing crossing;
            if (!counts(triangles[i].tissue) ||
                !leaves(ray, position(state.body, v[0]), position(state.body, v[1]),
                        position(state.body, v[2]), crossing))
                return;
            const double length = crossing.at_m + before_m;
            const double depth = length * crossing.normal.dot(ray.direction);
            if (depth < kBuriedM || length <= out.length_m) return;
            out = {depth, length, Vec3::Zero(), triangles[i].tissue};
            for (int k = 0; k < 3; ++k)
                out.rest +=
                    crossing.weight[k] * scene.body.mesh().rest[origin_of(state.body, v[k])];
        });
}

/// Of one blade, from its tip to the hinge. Open blades stand in tissue to cut it, and nothing
/// pushes them out; nobody has to cut the placode.
void blade_in_placode(const Scene& scene, const State& state, int t, double side,
                      Burial& out) noexcept {
    const double length = scene.tools[t].tip_length_m;
    const double tip_y = side * length * half_tangent(state.scissors[t].jaw_rad);
    const Pose& pose = state.tools[t].proxy;
    const Vec3 to_hinge(0, -tip_y, -length);
    const ShaftRay ray{pose * Vec3(0, tip_y, 0), pose.q * to_hinge.normalized(), to_hinge.norm()};
    deepest_along(
        scene, state, ray, 0, [](Tissue tissue) noexcept { return tissue == Tissue::kPlacode; },
        out);
}

}  // namespace

Burial burial_of(const Scene& scene, const State& state, int t) noexcept {
    Burial out;
    const ToolSpec& spec = scene.tools[t];
    const ToolState& tool = state.tools[t];
    if (spec.kind == ToolKind::kScope || !tool.engaged || at_work(scene, state, t)) return out;
    const double radius = state.scratch->contacts.shapes[t].parts[0].near_radius_m;
    const bool blades = spec.kind == ToolKind::kScissors;
    const double start = blades ? spec.tip_length_m : radius;
    const ShaftRay ray{tool.proxy * Vec3(0, 0, -start), tool.proxy.q * Vec3(0, 0, -1)};
    deepest_along(
        scene, state, ray, blades ? 0 : radius, [](Tissue) noexcept { return true; }, out);
    if (blades_open(scene, state, t))
        for (const double side : {-1.0, 1.0}) blade_in_placode(scene, state, t, side, out);
    return out;
}

}  // namespace placode::sim

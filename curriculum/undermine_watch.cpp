// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/undermine_watch.h"

#include "sim/cutting/plane_parting.h"

namespace placode::curriculum {

using sim::Vec3;

namespace {

/// Side of the slit that a tool reaches below: away from its port. 1 = left, -1 = right.
int undermined_side(const sim::Scene& scene, size_t tool) noexcept {
    const auto& stations = scene.slit.stations;
    if (stations.empty()) return 1;
    const auto& middle = stations[stations.size() / 2];
    const Vec3 left = scene.body.mesh().rest[static_cast<size_t>(middle.left[0])],
               right = scene.body.mesh().rest[static_cast<size_t>(middle.right[0])];
    const Vec3 port = scene.tools[tool].pivot_m - 0.5 * (left + right);
    return port.head<2>().dot((left - right).head<2>()) > 0 ? -1 : 1;
}

/// What still holds next to the wound's edge on a side, where it lies now, in W [m]; false where
/// all that is to be freed is free.
bool next_to_free(const sim::Scene& scene, const sim::State& state, int side, Vec3& at_m) noexcept {
    double nearest = 1;
    int32_t found = -1;
    for (const auto& ray : scene.plane.rays) {
        if (ray.side != side) continue;
        double reach = 0;
        for (const auto& s : ray.stretches) {
            if (reach >= nearest || reach > sim::DissectionPlane::kWantedM) break;
            if (scene.plane.faces[static_cast<size_t>(s.face)].wanted &&
                !is_parted(scene, state, s.face)) {
                nearest = reach;
                found = s.face;
                break;
            }
            reach = static_cast<double>(s.until_m);
        }
    }
    if (found < 0) return false;
    const auto& face = scene.plane.faces[static_cast<size_t>(found)];
    const auto& c = corners(scene.body, state.body, face.above[0]);
    at_m = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
        if (k != face.face) at_m += position(state.body, c[static_cast<size_t>(k)]) / 3;
    return true;
}

}  // namespace

assessment::UndermineSight look_at_undermining(const sim::Scene& scene,
                                               const sim::State& state) noexcept {
    std::array<double, 2> freed{};
    for (const int side : {-1, 1}) {
        const sim::UnderminedArea area = undermined_area(scene, state, side);
        freed[side > 0 ? 1 : 0] = area.wanted_m2 > 0 ? area.parted_m2 / area.wanted_m2 : 1;
    }
    assessment::UndermineSight sight;
    for (size_t i = 0; i < scene.tools.size(); ++i)
        sight.freed[i] = freed[undermined_side(scene, i) > 0 ? 1 : 0];
    return sight;
}

void show_undermining(const sim::Scene& scene, const sim::State& state,
                      sim::PracticeGoal& goal) noexcept {
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        if (scene.tools[i].hand != goal.step.hand) continue;
        const bool there = next_to_free(scene, state, undermined_side(scene, i), goal.target_m[0]);
        goal.targets = there ? 1 : 0;
    }
}

}  // namespace placode::curriculum

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_field.h"

namespace placode::view {

using namespace sim;

ViewField view_field(const Scene& scene, uint64_t seed) {
    ViewField field;
    field.rest.reserve(scene.body.mesh().rest.size());
    for (const Vec3& p : scene.body.mesh().rest) {
        field.rest.push_back(
            {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
    field.depth_m = scene.field.depth_m;
    const auto triangles = scene.surface.rest_triangles();
    field.rest_triangles.assign(triangles.begin(), triangles.end());
    field.placode_edge = scene.geometry.placode_edge;
    field.skin_edge = scene.geometry.skin_edge;
    if (scene.sac.present()) field.floor = scene.sac.floor;
    field.tools = scene.tools;
    field.seed = seed;
    return field;
}

}  // namespace placode::view

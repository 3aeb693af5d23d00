// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the renderer must know of a scene before the first picture: the rest shape, the anatomy's
// outlines and the instruments. A value of its own so that the view can be tested without physics.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/world/scene.h"

namespace placode::view {

struct ViewField {
    std::vector<std::array<float, 3>> rest;            ///< (V) rest positions [m].
    std::vector<float> depth_m;                        ///< (V) below the rest surface; empty = 0.
    std::vector<sim::SurfaceTriangle> rest_triangles;  ///< Boundary at rest.
    std::vector<sim::Vec3> placode_edge, skin_edge;    ///< Closed outlines on the surface [m].
    sim::CanalFloor floor;                             ///< Below a sac; empty without one.
    std::vector<sim::ToolSpec> tools;
    uint64_t seed = 1;  ///< Vessels, flecks and hairs.
};

[[nodiscard]] ViewField view_field(const sim::Scene& scene, uint64_t seed);

}  // namespace placode::view

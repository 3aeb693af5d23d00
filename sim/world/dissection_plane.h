// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The plane between skin and fascia in which skin is undermined: the faces where subcutis lies on
// what is below it, beside a slit that reaches down to there.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Never changes. The subcutis is one layer of prisms, each of three tets; one of the three has the
/// face on the plane.
struct DissectionPlane {
    struct Face {
        std::array<int32_t, 3> above{};  ///< Tets of the prism; the first has the face,
        int8_t face = 0;                 ///< opposite to this corner of it.
        int8_t side = 0;                 ///< Of the slit: 1 = left, -1 = right.
        bool wanted = false;             ///< Below a line from an edge, within kWantedM of it.
        bool beyond = false;             ///< Farther than kMostM from the edges.
        float area_m2 = 0;               ///< At rest.
        Vec3 middle_m = Vec3::Zero();    ///< At rest, on the plane.
    };
    /// What lies below a line from a slit's edge outwards.
    struct Stretch {
        int32_t face = -1;
        float until_m = 0;  ///< Along the line, from the edge.
    };
    /// From a station of one wall of the slit, straight away from the other wall.
    struct Ray {
        int32_t station = 0;
        int8_t side = 0;
        Vec3 edge_m = Vec3::Zero();  ///< Where it begins, on the surface at rest.
        Vec3 out = Vec3::UnitY();    ///< Its direction, in the plane.
        std::vector<Stretch> stretches;
    };
    static constexpr double kMostReachM = 0.020;  ///< Of a ray.
    /// So far from the edges skin is to be freed, and no farther than the second. Planning values
    /// of a pad; in theatre it is 10 to 20 mm.
    static constexpr double kWantedM = 0.008, kMostM = 0.013;

    double strength_pa = 0;  ///< Traction at which it parts.
    std::vector<Face> faces;
    std::vector<Ray> rays;

    [[nodiscard]] bool present() const noexcept { return !faces.empty(); }
};

}  // namespace placode::sim

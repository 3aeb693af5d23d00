// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A pad with a wide wound and a plane below its skin.

#include <algorithm>

#include "sim/anatomy/operative_field.h"
#include "sim/cutting/separation.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"
#include "tests/flat_pad.h"

namespace placode::sim::test {

/// Planning values; a coarse mesh, for speed.
inline OperativeFieldSpec undermine_pad() {
    OperativeFieldSpec spec = flat_pad();
    spec.domain_x_m = 0.044;
    spec.domain_y_m = 0.028;
    spec.edge_ring_m = spec.edge_placode_m = 0.0007;
    spec.edge_outer_m = 0.0024;
    spec.edge_growth = 0.12;
    spec.skin_edge_a_m = spec.skin_edge_b_m = 0.0022;
    spec.placode_a_m = spec.placode_b_m = 0.0008;
    spec.contour_offset_m = 0.0006;
    spec.band_outside_m = 0.0005;
    spec.spare_vertices = 4000;
    spec.contact.self_contact = true;
    spec.tear_radius_m = 0.0005;
    spec.slit.emplace();
    spec.slit->from_m = Vec2(0.0045, 0);
    spec.slit->to_m = Vec2(0.0165, 0);
    spec.slit->width_m = 0.004;
    spec.slit->layers = 3;
    spec.slit->edge_m = 0.0011;
    spec.plane.emplace();
    Material& subcutis = spec.materials[static_cast<size_t>(Tissue::kSubcutis)];
    subcutis.youngs_modulus_pa = 6000;
    subcutis.fail_stretch = 3.5;
    subcutis.injury_stretch = 3;
    for (const double side : {-1.0, 1.0}) {
        ToolSpec grasper;
        grasper.kind = ToolKind::kGrasper;
        grasper.hand = side < 0 ? Hand::kRight : Hand::kLeft;
        grasper.pivot_m = Vec3(0.0105, side * 0.085, 0.017);
        grasper.shaft_radius_m = 0.001;
        grasper.tip_radius_m = 0.0005;
        grasper.tip_length_m = 0.012;
        grasper.jaw_open_rad = 0.8;
        grasper.jaws_spread = true;
        spec.tools.push_back(grasper);
    }
    return spec;
}

/// Parts the plane within a distance of the wound's edges.
inline void part_within(const Scene& scene, State& state, double reach_m) {
    for (const DissectionPlane::Face& face : scene.plane.faces) {
        double nearest = 1;
        for (const DissectionPlane::Ray& ray : scene.plane.rays)
            nearest = std::min(nearest, (face.middle_m - ray.edge_m).head<2>().norm());
        if (nearest < reach_m) static_cast<void>(cut_face(scene, state, face.above[0], face.face));
    }
}

}  // namespace placode::sim::test

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What all pads of the tests have in common: flat, of even skin at rest, without heat. Sizes and
// edges are the test's.

#include "sim/anatomy/operative_field.h"

namespace placode::sim::test {

inline OperativeFieldSpec flat_pad() {
    OperativeFieldSpec spec;
    spec.id = "pad";
    spec.domain_y_m = 0.016;
    spec.thin_skin_width_m = 0.0003;
    spec.dome_height_m = spec.wobble = spec.groove_depth_m = spec.rim_height_m = 0;
    spec.relief_skin_m = spec.relief_placode_m = 0;
    spec.base_radius_x_m = spec.base_radius_y_m = 1000;
    spec.skin_prestretch = spec.zone_prestretch = 1;
    spec.heat = false;
    return spec;
}

}  // namespace placode::sim::test

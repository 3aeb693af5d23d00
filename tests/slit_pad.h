// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pad of the tests about slits.

#include "tests/flat_pad.h"

namespace placode::sim::test {

inline constexpr double kWidthM = 0.001, kHalfM = 0.006;  // of the slit, across and along

/// A flat pad of even skin with a slit along +y, as in data/scenes/suture_slit_pad.json.
inline OperativeFieldSpec pad() {
    OperativeFieldSpec spec = flat_pad();
    spec.domain_x_m = 0.0315;
    spec.edge_ring_m = spec.edge_placode_m = 0.0007;
    spec.edge_outer_m = 0.0009;
    spec.skin_edge_a_m = spec.skin_edge_b_m = 0.0027;
    spec.placode_a_m = spec.placode_b_m = 0.001;
    spec.contour_offset_m = 0.0006;
    spec.contact.self_contact = true;
    spec.slit = FieldSlit{Vec2(0.009, -kHalfM), Vec2(0.009, kHalfM), kWidthM, 2, 0.0005};
    return spec;
}

}  // namespace placode::sim::test

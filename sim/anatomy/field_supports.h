// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the tissue of an operative field lies on and hangs on: bone and muscle below, tissue beyond
// its sides, strands under the placode, the pressure in a slit.

#include "sim/anatomy/field_mesh.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Muscle and bone below the field: fixed vertices, and springs by area.
void lay_on_bed(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body);

/// The tissue beyond the domain yields in the plane: the row next to the held one hangs on springs.
/// Each of its columns takes the side area of its share of the outline.
void hang_on_sides(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body);

/// Roots of a placode on a sac, or strands through the gel under one that lies in a canal.
void tie_placode(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body);

/// Walls and floor of a slit that will be tested under pressure bear loads (set_load()).
void take_pressure(const FieldMesh& field, SoftBodySpec& body);

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The marked tissue of a field: a sector of the zone between planned incision and skin edge.

#include "sim/anatomy/field_mesh.h"
#include "sim/anatomy/operative_field.h"

namespace placode::sim {

/// Marks tets and lays the outline on the surface. Does nothing where the spec marks nothing.
void mark_resection(const OperativeFieldSpec& spec, const FieldShape& shape, const FieldMesh& field,
                    Scene& scene);

}  // namespace placode::sim

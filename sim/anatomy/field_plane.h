// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/anatomy/field_mesh.h"
#include "sim/mesh/surface.h"
#include "sim/world/dissection_plane.h"

namespace placode::sim {

/// The plane below the subcutis and the rays on it from the slit's edges; nothing where the spec
/// has none.
[[nodiscard]] DissectionPlane make_plane(const OperativeFieldSpec& spec, const FieldMesh& field,
                                         const Surface& surface);

}  // namespace placode::sim

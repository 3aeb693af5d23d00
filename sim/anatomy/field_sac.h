// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sac of the cystic field: its underside, what lies over each part of it, and the canal's
// floor.

#include "sim/anatomy/field_mesh.h"
#include "sim/cutting/sac.h"

namespace placode::sim {

/// @pre spec.cystic
[[nodiscard]] Sac make_sac(const OperativeFieldSpec& spec, const FieldShape& shape,
                           const FieldMesh& field);

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Irrigation over the operative field: the ground on which fluid stands, and debris at places drawn
// by the seed.

#include <optional>

#include "sim/anatomy/field_mesh.h"
#include "sim/anatomy/operative_field.h"

namespace placode::sim {

/// Appends the springs that bear jets to the body; nothing without irrigation. Call it when all
/// other springs are there.
[[nodiscard]] std::optional<Irrigation> add_irrigation(const OperativeFieldSpec& spec,
                                                       const FieldShape& shape,
                                                       const FieldMesh& field, SoftBodySpec& body);

}  // namespace placode::sim

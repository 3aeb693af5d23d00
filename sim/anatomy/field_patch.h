// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A patch over the operative field: its triangles, where it lies at the start, and what of the
// tissue can bear it.

#include <optional>

#include "sim/anatomy/field_mesh.h"
#include "sim/anatomy/operative_field.h"

namespace placode::sim {

/// Most triangles of a patch: lists of contacts have room for so many vertices, and its share of
/// a substep stays small.
inline constexpr int kMostPatchTriangles = 1600;

/// Appends the patch to the body; nothing without one. Call it when all springs are there.
/// @throws MeshError where it reaches beyond the field.
[[nodiscard]] std::optional<Patch> add_patch(const OperativeFieldSpec& spec, const FieldMesh& field,
                                             SoftBodySpec& body);

}  // namespace placode::sim

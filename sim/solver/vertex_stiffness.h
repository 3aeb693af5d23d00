// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/geometry.h"

namespace placode::sim {

class SoftBody;
struct SoftBodyState;

/// The Hessian of vertex_system() alone [N/m], with the same bits: what a vertex answers while its
/// neighbours are held. Cheaper where it is part of a sheet, as angles are not asked for.
[[nodiscard]] Mat3 vertex_stiffness(const SoftBody& body, const SoftBodyState& state, int vertex,
                                    double h) noexcept;

}  // namespace placode::sim

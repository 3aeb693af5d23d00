// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the tetrahedra as they are now do not say any more what lies ahead of a point.

#include "sim/suture/tissue_point.h"

namespace placode::sim {

/// As walk_to_face(), through the tet as it is at rest, where none is flat; `way` is taken as it
/// stands.
[[nodiscard]] TissueWalk walk_at_rest(const SuturedTissue& tissue, const TissuePoint& from,
                                      const Vec3& offset) noexcept;

}  // namespace placode::sim

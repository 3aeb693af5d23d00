// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An order of points in which neighbours in the list are neighbours in space.

#include <cstdint>
#include <vector>

#include "sim/mesh/mesh.h"

namespace placode::sim {

/// Place of every point along a Hilbert curve through the cube around all of them (V), 10 bits an
/// axis. Source: Skilling 2004, "Programming the Hilbert curve".
[[nodiscard]] std::vector<uint32_t> hilbert_keys(const std::vector<Vec3>& points);

}  // namespace placode::sim

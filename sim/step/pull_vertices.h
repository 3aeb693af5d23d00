// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What force holds tissue where it is drawn to.

#include <span>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// A vertex and where it shall come to.
struct PulledVertex {
    int32_t vertex = -1;
    Vec3 to_m = Vec3::Zero();
};

/// Draws vertices evenly to their places, holds them there until the tissue is at rest, and returns
/// the force with which it pulls on each of them [N]. Without instruments and without contact;
/// nothing tears or parts. Spoils this state. The same on every number of threads. Allocates.
[[nodiscard]] std::vector<Vec3> pull_vertices(const Scene& scene, State& state,
                                              std::span<const PulledVertex> pulled);

}  // namespace placode::sim

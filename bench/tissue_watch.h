// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a hard case asks of the tissue: how far it has gone, and whether it has come to rest.

#include <span>

#include "sim/step/step.h"

namespace placode::bench {

/// Largest way of tissue that something holds from where it lay [m], 1 where one is no number; what
/// was torn off drifts or goes where it is drawn.
/// @param at_rest places of the vertices before anything came; of those that cuts have not made.
[[nodiscard]] double farthest_tissue(const sim::Scene& scene, const sim::State& state,
                                     std::span<const sim::Float4> at_rest);

/// Speed of the fastest vertex that anything holds [m/s], 1000 where one is no number; crumbs
/// drift.
[[nodiscard]] double fastest_vertex(const sim::State& state);

}  // namespace placode::bench

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far skin is undermined, and where to go on. Physics thread; allocates nothing. Private to
// curriculum.

#include "assessment/practice.h"
#include "sim/step/step.h"

namespace placode::curriculum {

/// The share that is free on the side away from each tool's port; all of it in a scene without a
/// plane.
[[nodiscard]] assessment::UndermineSight look_at_undermining(const sim::Scene& scene,
                                                             const sim::State& state) noexcept;

/// Sets the target of a step of undermining.
void show_undermining(const sim::Scene& scene, const sim::State& state,
                      sim::PracticeGoal& goal) noexcept;

}  // namespace placode::curriculum

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which scripted operator a set of instruments asks for: a needle makes the ring, a grasper lifts,
// a needle driver sutures, two of them hand the needle over, grasper and scissors resect, all three
// do the whole dissection; a task with steps has its own, and one that lays a patch.

#include <memory>
#include <span>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// `homes_m`: tips at rest in W, one for each of `config.tools`.
[[nodiscard]] std::unique_ptr<ScriptedOperator> open_operator(const DeviceConfig& config,
                                                              OperatorLevel level,
                                                              std::span<const Vec3> homes_m);

/// Angle by which the handle must turn so that jaws open along `opening` (either way round is the
/// same), from `roll_rad`, at the pose that the instrument has without roll.
[[nodiscard]] double turn_to_open_along(const Vec3& opening, const sim::Pose& straight,
                                        double roll_rad) noexcept;

/// The same until the jaws' width (+x of T) lies along `across`: only one way round is right.
[[nodiscard]] double turn_to_lie_along(const Vec3& across, const sim::Pose& straight,
                                       double roll_rad) noexcept;

}  // namespace placode::haptics

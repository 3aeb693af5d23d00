// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where each instrument is wanted next, as the picture shows it to a person: the target of the
// step, the stretch of the line that is not followed or cut yet, the place to take hold.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/device.h"

namespace placode::environment {

struct ToolGoals {
    std::array<std::optional<sim::Vec3>, sim::kMaxTools> place_m;  ///< By tool, in W; empty = none.
    /// What has to come there: the tip, or the point of the needle that it holds.
    std::array<sim::Vec3, sim::kMaxTools> from_m;
    std::array<double, sim::kMaxTools> after_m{};  ///< Way that is left once it is there.
    std::array<double, sim::kMaxTools> away_m{};   ///< All of the way, where there is a goal.
    /// Changes when something was reached: distances before and after are not to be compared.
    int64_t reached = 0;
};

/// @param tips_m where the tips are, by tool.
[[nodiscard]] ToolGoals goals_of(std::span<const sim::ToolSpec> tools,
                                 const haptics::Perception& seen,
                                 std::span<const sim::Vec3> tips_m);

/// Place in `points` nearest to `from` among those whose `done` is 0; empty = none is left.
[[nodiscard]] std::optional<sim::Vec3> nearest_undone(std::span<const sim::Vec3> points,
                                                      std::span<const uint8_t> done,
                                                      const sim::Vec3& from);

}  // namespace placode::environment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the story of a metric can be seen: the moment in the recording and the place on the clock.

#include <optional>
#include <string_view>

#include "assessment/metrics.h"
#include "assessment/reason.h"
#include "sim/core/geometry.h"

namespace placode::assessment {

struct Locus {
    std::optional<sim::Vec2> at_m;  ///< At rest.
    double time_s = -1;             ///< -1 = the whole attempt.
    int count = 0;                  ///< Events behind it.
    BetweenBites between;           ///< Of what a slit leaks: which bites lie beside the place.
};

/// Of an event on the tissue, at rest [m].
[[nodiscard]] inline sim::Vec3 rest_place(const sim::Event& event) {
    const auto& p = event.rest_position_m;
    return {p[0], p[1], p[2]};
}

/// @param threshold of the line that asks: time is used up from there on.
[[nodiscard]] Locus locate(std::string_view metric, double threshold,
                           const sim::Recording& recording);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a policy gets to see, as numbers with names. The names are the interface: later versions
// append, they never change what a name means.

#include <span>
#include <string>
#include <vector>

#include "environment/episode_book.h"
#include "environment/goals.h"
#include "environment/hands.h"
#include "sim/step/step.h"

namespace placode::environment {

/// Everything that an observation is made from.
struct Sight {
    const sim::Scene& scene;
    const sim::State& state;
    const haptics::Perception& seen;
    const ToolGoals& goals;
    const Hands& hands;
    const EpisodeBook& book;
    std::span<const sim::Pose> poses;  ///< Where the instruments are, X_WT.
    double time_limit_s = 0, points = 0;
};

/// One name per number, each ending in its unit; a number without one is a share, a count or 0/1.
/// "tool0.tip_x_mm": tools in the order of the scene.
/// @param needle the scene has a suture needle: its numbers come last.
[[nodiscard]] std::vector<std::string> observation_names(size_t tools, bool needle);
/// As many numbers as there are names.
void observe(const Sight& sight, std::span<double> out);

}  // namespace placode::environment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What tests of environments share: a field that a test can afford, actions by chance.

#include <memory>
#include <string>
#include <vector>

#include "environment/environment.h"
#include "sim/core/random.h"
#include "tests/coarse_scene.h"

namespace placode::test {

inline environment::EnvironmentOptions coarse() {
    environment::EnvironmentOptions options;
    options.scene_changes_json = kCoarseScene;
    options.fields = 1;
    return options;
}

inline std::vector<double> random_action(const environment::Environment& environment,
                                         sim::SplitMix64& random) {
    std::vector<double> action(environment.tools() * environment::kActionSize);
    for (double& number : action) number = random.uniform(-1, 1);
    return action;
}

inline std::vector<double> observation_of(environment::Environment& environment) {
    std::vector<double> out(environment.observation_names().size());
    environment.observe(out);
    return out;
}

/// One number of an observation, by its name.
inline double seen(environment::Environment& environment, const std::string& name) {
    const auto& names = environment.observation_names();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) throw std::runtime_error("no number " + name);
    return observation_of(environment)[static_cast<size_t>(at - names.begin())];
}

}  // namespace placode::test

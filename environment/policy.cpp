// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/policy.h"

#include <algorithm>
#include <cassert>

namespace placode::environment {
namespace {

/// Random holds a wish for a fifth of a second, or it would only tremble.
constexpr double kHoldS = 0.2;

bool scripted(std::string_view name) { return name != "nothing" && name != "random"; }

}  // namespace

ActionUnits policy_units(std::string_view name) {
    return scripted(name) ? ActionUnits::kAbsolute : ActionUnits::kNormalised;
}

Policy::Policy(const std::string& name, const Environment& environment, uint64_t seed)
    : random_(name == "random"), numbers_(seed), held_s_(kHoldS) {
    assert(environment.began());
    if (std::find(kPolicies.begin(), kPolicies.end(), name) == kPolicies.end())
        throw EnvironmentError(
            EnvironmentError::Kind::kBadArgument,
            "no policy \"" + name + "\"; expected expert, intermediate, novice, nothing or random");
    if (scripted(name)) operator_ = std::make_unique<Expert>(environment, name, seed);
}

bool Policy::act(Environment& environment, int frames, std::span<double> actions) {
    if (operator_) return operator_->act(environment, frames, actions);
    if (!random_) {
        std::fill(actions.begin(), actions.end(), 0.0);
        for (size_t i = kActionEngaged; i < actions.size(); i += kActionSize) actions[i] = 1;
        return false;
    }
    const double step_s = frames * environment.task().scene.solver.frame_s;
    if (held_s_ >= kHoldS - step_s / 2) {
        held_s_ = 0;
        for (double& number : actions) number = numbers_.uniform(-1, 1);
    }
    held_s_ += step_s;
    return false;
}

}  // namespace placode::environment

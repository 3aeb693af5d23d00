// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Policies that need no learning, to compare others with: nothing, chance, scripted operators.

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "environment/expert.h"
#include "sim/core/random.h"

namespace placode::environment {

inline constexpr std::array<std::string_view, 5> kPolicies{"expert", "intermediate", "novice",
                                                           "nothing", "random"};

/// In which units the policy acts: the environment must have the same.
[[nodiscard]] ActionUnits policy_units(std::string_view name);

/// Of one attempt. Deterministic: name, seed and environment give the actions.
class Policy {
 public:
    /// @param name one of kPolicies. Throws EnvironmentError. @pre the environment was reset.
    Policy(const std::string& name, const Environment& environment, uint64_t seed);

    /// The action for the next `frames` frames. True = it is done with the task.
    [[nodiscard]] bool act(Environment& environment, int frames, std::span<double> actions);

 private:
    std::unique_ptr<Expert> operator_;  // of the scripted ones
    bool random_ = false;
    sim::SplitMix64 numbers_;
    double held_s_ = 0;  // since random last drew
};

}  // namespace placode::environment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What nothing, chance and the scripted expert reach in an environment.

#include <memory>

#include "bench/environment_speed.h"
#include "environment/expert.h"
#include "sim/core/random.h"

namespace placode::bench {
namespace {

using environment::Environment;

constexpr int kFrames = 20;

enum class Policy { kNothing, kChance, kExpert };
constexpr std::pair<Policy, const char*> kPolicies[] = {{Policy::kNothing, "nothing"},
                                                        {Policy::kChance, "chance"},
                                                        {Policy::kExpert, "scripted expert"}};

/// One attempt; adds what came of it.
void perform(Environment& environment, Policy policy, uint64_t seed, PolicyRow& row) {
    environment.reset(seed);
    environment::Expert expert(environment, "expert", seed);
    sim::SplitMix64 random(seed);
    std::vector<double> action(environment.tools() * environment::kActionSize, 0.0);
    for (size_t i = 0; i < environment.tools(); ++i) action[i * environment::kActionSize + 7] = 1;
    environment::StepOutcome outcome;
    for (int step = 0; !environment.ended(); ++step) {
        bool done = false;
        if (policy == Policy::kExpert) done = expert.act(environment, kFrames, action);
        // Chance holds a wish for a fifth of a second, or it would only tremble.
        if (policy == Policy::kChance && step % 10 == 0)
            for (double& number : action) number = random.uniform(-1, 1);
        outcome = environment.step(action, kFrames, done);
        row.reward += outcome.reward;
    }
    ++row.attempts;
    row.successes += outcome.success ? 1 : 0;
    row.points += environment.judged().score.points;
    row.duration_s += environment.state().time_s;
}

}  // namespace

std::vector<PolicyRow> measure_policies(const EnvironmentCase& what, int attempts, double floor_s,
                                        const std::function<void(const PolicyRow&)>& measured) {
    std::vector<PolicyRow> rows;
    const auto fields = std::make_shared<environment::FieldCache>();
    for (const auto& [policy, name] : kPolicies) {
        environment::EnvironmentOptions options;
        options.units = policy == Policy::kExpert ? environment::ActionUnits::kAbsolute
                                                  : environment::ActionUnits::kNormalised;
        options.scene_changes_json = what.scene_changes_json;
        if (policy != Policy::kExpert) options.time_limit_s = floor_s;
        Environment environment(fields, what.task, options);
        PolicyRow row;
        row.task = what.task;
        row.policy = name;
        for (int i = 0; i < attempts; ++i)
            perform(environment, policy, static_cast<uint64_t>(i) + 1, row);
        row.points /= attempts;
        row.reward /= attempts;
        row.duration_s /= attempts;
        measured(row);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace placode::bench

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What nothing, chance and the scripted expert reach in an environment.

#include <memory>

#include "bench/environment_speed.h"
#include "environment/policy.h"

namespace placode::bench {
namespace {

using environment::Environment;

/// As environment/policy.h names them, and as people read it.
constexpr std::pair<const char*, const char*> kPolicies[] = {
    {"nothing", "nothing"}, {"random", "chance"}, {"expert", "scripted expert"}};

/// One attempt; adds what came of it.
void perform(Environment& environment, const std::string& name, uint64_t seed, PolicyRow& row) {
    environment.reset(seed);
    environment::Policy policy(name, environment, seed);
    std::vector<double> action(environment.tools() * environment::kActionSize, 0.0);
    environment::StepOutcome outcome;
    while (!environment.ended()) {
        const bool done = policy.act(environment, kFramesAStep, action);
        outcome = environment.step(action, kFramesAStep, done);
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
    for (const auto& [policy, words] : kPolicies) {
        environment::EnvironmentOptions options;
        options.units = environment::policy_units(policy);
        options.scene_changes_json = what.scene_changes_json;
        if (policy != std::string_view("expert")) options.time_limit_s = floor_s;
        Environment environment(fields, what.task, options);
        PolicyRow row;
        row.task = what.task;
        row.policy = words;
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

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What environments cost (environment/environment.h): frames a second beside the bare physics,
// reset, memory; and what policies to compare with reach. Wall clock, one thread.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placode::bench {

inline constexpr int kFramesAStep = 20;  ///< Of an environment: 20 ms.

struct EnvironmentCase {
    std::string name, task;
    std::string scene_changes_json;  ///< Empty = the task's own scene.
};

struct EnvironmentRow {
    EnvironmentCase what;
    int tets = 0, substeps = 0;
    double physics_hz = 0;      ///< Frames a second of sim::step alone, with the same inputs.
    double environment_hz = 0;  ///< With recording, goals, reward and an observation every 20 ms.
    double reset_ms = 0;        ///< From a saved moment.
    double save_ms = 0;
    double field_mib = 0, environment_mib = 0, moment_mib = 0;
    double build_s = 0;  ///< Of the field, settled.
};

/// `runs` runs of 2 simulated seconds of a scripted expert at work, physics alone and environment
/// in turns, medians. Throws DefinitionError.
[[nodiscard]] EnvironmentRow measure_environment(const EnvironmentCase& what, int runs);

/// Memory that 8 environments of one field take, against 8 with a field each [MiB].
struct SharingRow {
    int environments = 8;
    double shared_mib = 0, apart_mib = 0;
};
[[nodiscard]] SharingRow measure_sharing(const EnvironmentCase& what);

struct PolicyRow {
    std::string task, policy;
    int attempts = 0, successes = 0;
    double points = 0, reward = 0, duration_s = 0;  ///< Means.
};
/// Nothing, chance and the scripted expert in `attempts` attempts each, through the environment's
/// own actions. Nothing and chance are stopped after `floor_s` of simulated time.
[[nodiscard]] std::vector<PolicyRow> measure_policies(
    const EnvironmentCase& what, int attempts, double floor_s,
    const std::function<void(const PolicyRow&)>& measured);

}  // namespace placode::bench

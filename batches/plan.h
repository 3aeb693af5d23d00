// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From an order to a manifest.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batches/manifest.h"

namespace placode::batches {

/// A recording and, where a store keeps it, whose score it is.
struct OrderedRecording {
    std::filesystem::path path;
    int64_t attempt = 0;                ///< Of the store; 0 = of none.
    std::optional<double> pass_points;  ///< rescore: instead of the rubric's, as on its day.
};

/// Recordings to score again or to simulate again.
struct RecordingsOrder {
    std::string kind;  ///< "rescore" or "replay".
    std::vector<OrderedRecording> recordings;
    std::string task;      ///< rescore: judge all by this one; empty = each by the program's own.
    bool metrics = false;  ///< rescore: with every metric in the result.
    int threads = 1;       ///< replay
};

/// Attempts of built-in policies (environment/policy.h).
struct RolloutsOrder {
    std::vector<std::string> tasks, policies;
    std::vector<uint64_t> seeds;
    int frames_per_step = 20;
    double time_limit_s = 0;         ///< 0 = as the task says.
    std::string scene_changes_json;  ///< Merged into every scene; empty = none.
    bool metrics = false;            ///< With every metric in the result.
    bool record = false;             ///< Keep the recordings, in the batch's folder.
};

/// Throws BatchError unless it is one of environment::kPolicies.
void need_policy(const std::string& name);

/// Recordings in a folder, sorted by name. Throws BatchError when there are none.
[[nodiscard]] std::vector<std::filesystem::path> recordings_in(const std::filesystem::path& folder);

/// Told before each file how many were read; what it throws ends the plan.
using PlanProgress = std::function<void(size_t done, size_t of)>;

/// Reads every file once, for its checksum. Files below `folder` are named from there, so that the
/// batch may be moved. Throws BatchError or DefinitionError.
[[nodiscard]] Manifest plan_recordings(const RecordingsOrder& order,
                                       const std::filesystem::path& folder,
                                       const PlanProgress& progress = {});
[[nodiscard]] Manifest plan_rollouts(const RolloutsOrder& order);

}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A score as a line of a result, and back: what a batch over the recordings of a store computed
// goes into that store (`placodectl batch keep`), rollouts show what a task's metrics are worth
// (`placodectl norms quality --batch`).

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "assessment/scoring.h"
#include "batches/manifest.h"
#include "db/rescore.h"

namespace placode::batches {

/// Points, verdict, rubric and versions.
[[nodiscard]] Json score_json(const assessment::Score& score);
[[nodiscard]] Json reasons_json(const assessment::Score& score);
/// In the order of the metrics; `{}` when there are none.
[[nodiscard]] Json metrics_json(const assessment::MetricSet& metrics);

/// What the batch says of a stored attempt.
struct StoredScore {
    std::string recording_sha256;  ///< Of the recording that was scored.
    std::string problem;           ///< Why it has no score; empty = it has one.
    db::ComputedScore score;
};

/// By the attempt's number in the store. Verifies every shard. Throws BatchError: kBadInput for a
/// batch that is no rescoring of recordings out of a store by one task, kFailed while shards are
/// missing or damaged.
[[nodiscard]] std::map<int64_t, StoredScore> scores_for_store(const std::filesystem::path& folder,
                                                              const Manifest& manifest);

/// What a policy reached.
struct RolloutScore {
    std::string task, policy;
    uint64_t seed = 0;
    double points = 0;
    assessment::Verdict verdict{};
    assessment::MetricSet metrics;
};

/// Verifies every shard. Throws BatchError: kBadInput for a batch that is no rollouts with metrics,
/// kFailed while shards are missing or damaged.
[[nodiscard]] std::vector<RolloutScore> scores_of_rollouts(const std::filesystem::path& folder,
                                                           const Manifest& manifest);

}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A batch through the centre's server (db/work_queue.h): whoever has it queues it with everything
// that its items read, idle computers pull shards, and the results come back into its folder as if
// they had been made there.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batches/items.h"
#include "batches/manifest.h"
#include "db/work_queue.h"

namespace placode::batches {

/// Told how many inputs are queued.
using InputProgress = std::function<void(size_t done, size_t of)>;

/// Throws BatchError for what cannot be done elsewhere: rollouts that keep their recordings.
void queue_batch(db::WorkQueue& queue, const std::filesystem::path& folder,
                 const Manifest& manifest, const InputProgress& progress);

struct PullOrder {
    std::filesystem::path folder;  ///< For inputs and results on their way; emptied again.
    std::string build;             ///< Of this program.
    std::string worker;            ///< What the others see of this computer.
    int lease_s = 300;             ///< Silent for so long, it loses its shard.
    GoOn go_on;
    /// Which shard it is at, and how far.
    std::function<void(const db::WorkLease&, size_t done, size_t of)> progress;
};

struct PullOutcome {
    int done = 0, lost = 0;  ///< lost: somebody else had it meanwhile.
    bool stopped = false;
    std::vector<std::string> failed;  ///< "shard 3: problem".
};

/// Shards that nobody is at, one after the other, until none is left or `go_on` says so. A problem
/// of this computer, such as a full disk, stops it as well and costs the shard no try.
[[nodiscard]] PullOutcome pull_shards(db::WorkQueue& queue, const PullOrder& order);

struct Collected {
    int fresh = 0, waiting = 0;
    std::vector<std::string> damaged;  ///< Results that do not fit this batch.
};
/// Writes what is done into shards/ of the batch's folder, each verified.
[[nodiscard]] Collected collect_results(db::WorkQueue& queue, const std::filesystem::path& folder,
                                        const Manifest& manifest);

}  // namespace placode::batches

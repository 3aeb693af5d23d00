// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All shards of a batch by worker processes on this computer. A worker that crashes loses its
// shard and no other; whoever kills the runner kills the workers as well.

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "batches/items.h"
#include "batches/manifest.h"

namespace placode::batches {

struct RunOrder {
    std::filesystem::path folder;
    /// Program and arguments of a worker; the shard's number is put behind them.
    std::vector<std::string> command;
    int jobs = 1;
    GoOn go_on;
    std::function<void(int done, int of)> progress;  ///< Several times a second.
};

struct RunOutcome {
    int done_before = 0, done = 0;
    bool stopped = false;
    std::vector<std::pair<int, std::string>> failed;  ///< Shard, and the last line of its log.
};

/// Does what is missing or damaged. What each worker says stands in logs/000012.log. Throws
/// BatchError when a shard is of another batch.
[[nodiscard]] RunOutcome run_batch(const Manifest& manifest, const RunOrder& order);

}  // namespace placode::batches

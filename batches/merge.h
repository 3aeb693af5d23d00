// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a batch is, and one file from all its shards.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batches/manifest.h"
#include "batches/shard.h"

namespace placode::batches {

struct BatchStatus {
    int shards = 0, done = 0;
    std::vector<int> missing;
    std::vector<std::string> damaged, of_another;  ///< What is wrong with which file.
    std::vector<int> damaged_shards;

    /// Missing or damaged, in their order.
    [[nodiscard]] std::vector<int> to_do() const;
};

/// Verifies the checksum of every shard.
[[nodiscard]] BatchStatus batch_status(const std::filesystem::path& folder,
                                       const Manifest& manifest);

/// Throws BatchError, naming all that is missing or damaged.
void need_all_shards(const BatchStatus& status);
/// Throws BatchError when it was done a moment ago and is so no more.
[[nodiscard]] Shard read_done_shard(const std::filesystem::path& folder, const Manifest& manifest,
                                    int shard);

/// Counts over a result: what a person asks first.
struct Summary {
    size_t items = 0, problems = 0;
    std::map<std::string, size_t> verdicts;  ///< Of rescored attempts and rollouts.
    size_t identical = 0, differ = 0;        ///< Of attempts simulated again.
};

/// Writes the lines of all items in their order, behind a head with their checksum: the same bytes
/// whatever the order, jobs or kills. Verifies every shard on the way. Throws BatchError, naming
/// what is missing or damaged; nothing is written then.
Summary merge_batch(const std::filesystem::path& folder, const Manifest& manifest,
                    const std::filesystem::path& result);

/// "3, 7 to 9 and 12".
[[nodiscard]] std::string ranges_text(const std::vector<int>& numbers);

}  // namespace placode::batches

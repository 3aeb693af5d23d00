// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What shards took, kept beside the results: those must not show a clock, or two runs would differ.

#include <filesystem>
#include <optional>
#include <vector>

#include "batches/manifest.h"

namespace placode::batches {

struct ShardCost {
    int shard = 0;
    size_t items = 0;
    double wall_s = 0;  ///< From the start of its worker on.
};

/// times/000012.json. Does nothing where it cannot be written: the result is what counts.
void keep_cost(const std::filesystem::path& folder, const ShardCost& cost) noexcept;
/// Of the shards that are done, in their order; what cannot be read is left out.
[[nodiscard]] std::vector<ShardCost> read_costs(const std::filesystem::path& folder,
                                                const Manifest& manifest);

/// Since the kernel started this process, to 10 ms: what a worker costs before its first line runs.
/// 0 where /proc does not say it.
[[nodiscard]] double seconds_of_this_process();

/// The whole batch in one go on one computer.
struct RunCost {
    int workers = 0;
    double wall_s = 0;
};
void keep_run_cost(const std::filesystem::path& folder, const RunCost& cost) noexcept;
[[nodiscard]] std::optional<RunCost> read_run_cost(const std::filesystem::path& folder);

}  // namespace placode::batches

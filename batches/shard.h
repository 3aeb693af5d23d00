// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A shard: some items in one file, shards/000012.jsonl. Its first line says of which batch it is
// and the checksum of the lines behind it, one for each item. The file is whole or not there.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batches/items.h"
#include "batches/manifest.h"

namespace placode::batches {

enum class ShardState : uint8_t {
    kMissing,
    kDone,
    kDamaged,   ///< Its checksum does not fit: it is done again.
    kOfAnother  ///< Of another batch or build: somebody else's work, never touched.
};

struct Shard {
    ShardState state = ShardState::kMissing;
    std::string problem;  ///< What is wrong with it.
    std::string lines;    ///< Of the items, with their ends.
};

[[nodiscard]] std::filesystem::path shard_path(const std::filesystem::path& folder, int shard);
[[nodiscard]] Shard read_shard(const std::filesystem::path& folder, const Manifest& manifest,
                               int shard);

/// Told how many items of the shard are done.
using ShardProgress = std::function<void(size_t done, size_t of)>;

/// Does a shard, unless it is done. One process at a time: a lock that goes with the process, so
/// that one which was killed holds nobody up. Throws BatchError (kBusy when another process is at
/// it), Stopped, and what its items throw; the shard is then as it was.
/// @param build of this program: it must be the manifest's.
/// @return false when it had been done before.
bool do_shard(const std::filesystem::path& folder, const Manifest& manifest, int shard,
              const std::string& build, const GoOn& go_on, const ShardProgress& progress);

}  // namespace placode::batches

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a batch is to do: every item with the checksums of what it reads, cut into shards. Written
// once; a seal over all of it shows a later change.
//
// A batch is a folder: manifest.json, shards/000012.jsonl, logs/, recordings/.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "curriculum/task.h"

namespace placode::batches {

using Json = nlohmann::ordered_json;

inline constexpr int kManifestFormat = 1;

struct Manifest {
    std::string kind;   ///< "rescore", "replay" or "rollouts".
    std::string build;  ///< Program and instruction set: bits are promised for the same only.
    Json options = Json::object();  ///< Of the kind.
    Json tasks = Json::array();     ///< {"ref", "id", "version", "sha256"} of those it uses.
    int shard_size = 1;             ///< Items in each shard but the last.
    Json items = Json::array();
    std::string seal;  ///< SHA-256 of the rest.

    [[nodiscard]] int shards() const;
    /// First item of a shard, and the one behind its last.
    [[nodiscard]] std::pair<size_t, size_t> range(int shard) const;
};

/// This program and what it computes with.
[[nodiscard]] std::string build_text(const std::string& program_version);

/// A task as a manifest names it. @param ref id of a shipped task, or path of a JSON file.
[[nodiscard]] Json task_entry(const std::string& ref);
/// The task again, a copy in the batch's folder first. Throws BatchError when its text is another
/// one now.
[[nodiscard]] curriculum::Task task_of_entry(const Json& entry,
                                             const std::filesystem::path& folder);
/// The entry of that ref, null when there is none.
[[nodiscard]] const Json* entry_of(const Manifest& manifest, const std::string& key,
                                   const std::string& value);

/// Seals it and makes the folder. Throws BatchError when there is another batch in the folder; the
/// same one again changes nothing.
void write_manifest(const std::filesystem::path& folder, Manifest& manifest);
/// Throws BatchError when there is none, it was changed, or another version of this program wrote
/// it.
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& folder);

/// Where a batch that was brought here keeps an input, by its SHA-256.
[[nodiscard]] std::filesystem::path own_input(const std::filesystem::path& folder,
                                              const std::string& sha256,
                                              const std::string& ending = {});

/// A file that the manifest names: what was brought, from the batch's folder, else absolute.
[[nodiscard]] std::filesystem::path input_path(const std::filesystem::path& folder,
                                               const Json& item);

}  // namespace placode::batches

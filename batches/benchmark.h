// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The benchmark for machine operators: tasks, seeds and budgets in one published file, entries that
// anybody can replay. An entry is a folder: entry.json and a recording for each task and seed.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batches/items.h"
#include "batches/manifest.h"

namespace placode::batches {

struct BenchmarkTask {
    std::string task;
    double budget_s = 0;  ///< Of simulated time; an attempt ends there at the latest.
};

struct Protocol {
    std::string id;
    int version = 0;
    int frames_per_step = 20;  ///< 1 ms each; what built-in policies decide in.
    Json scene_changes;        ///< Null = the scenes as published.
    std::vector<uint64_t> seeds;
    std::vector<BenchmarkTask> tasks;
    std::string sha256;  ///< Of its text, and of every task's.
};

/// The shipped protocol's file.
[[nodiscard]] std::filesystem::path shipped_protocol();
/// Throws BatchError naming file and key, or DefinitionError.
[[nodiscard]] Protocol read_protocol(const std::filesystem::path& path);
/// A task of the protocol, in the protocol's scene.
[[nodiscard]] curriculum::Task protocol_task(const Protocol& protocol, const std::string& task);

struct EntryOrder {
    std::string name;    ///< Of the operator, for the board.
    std::string policy;  ///< Built-in (environment/policy.h); empty = the recordings are there.
    std::string build;   ///< Of this program.
    std::vector<uint64_t> seeds;    ///< Held-out ones; empty = the protocol's.
    std::vector<std::string> only;  ///< These tasks; empty = all. An entry of some is not ranked.
};
/// Told before each attempt; false stops.
using EntryProgress = std::function<bool(const std::string& what)>;

/// Makes the attempts of a built-in policy, or takes the recordings that are in `folder`, and
/// writes entry.json there. Throws BatchError: an attempt is missing, made twice, too long, or of
/// another task or seed; a task is ordered that the protocol has not.
Json make_entry(const Protocol& protocol, const EntryOrder& order,
                const std::filesystem::path& folder, const EntryProgress& progress);

/// An entry is named by its folder or by the entry.json in it: the latter.
[[nodiscard]] std::filesystem::path entry_file(const std::filesystem::path& entry);

struct EntryCheck {
    std::vector<std::string> problems;  ///< Empty: the entry is genuine.
    bool replayed = false;  ///< False: by another build, so that bits prove nothing here.
};
/// Is the entry what it says? Its recordings, by checksum; its points, from them; and with `replay`
/// every attempt simulated again, with the protocol's task and scene and not those in the file.
/// Throws BatchError when entry.json cannot be read, and Stopped.
[[nodiscard]] EntryCheck check_entry(const Protocol& protocol,
                                     const std::filesystem::path& entry_json, bool replay,
                                     const EntryProgress& progress);
[[nodiscard]] Json read_entry(const std::filesystem::path& entry_json);
/// For the board: with all that `board_text` prints, whatever its benchmark. Throws BatchError that
/// names file and key.
[[nodiscard]] Json read_board_entry(const std::filesystem::path& entry_json);

/// The leader board as Markdown: best first, entries of all tasks by the protocol's own seeds
/// before those by held-out seeds. `checks[i]` belongs to `entries[i]`.
[[nodiscard]] std::string board_text(const Protocol& protocol, const std::vector<Json>& entries,
                                     const std::vector<EntryCheck>& checks);

}  // namespace placode::batches

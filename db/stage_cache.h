// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stages begin with, kept in the user's cache folder: the scripted expert takes about as long
// to get there as a person. A file belongs to one program, task with its scene, case and stage;
// whatever is damaged or of another program is as if it were not there, and is made anew.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "curriculum/stage_start.h"

namespace placode::db {

/// What the folder may take; the oldest files go first.
inline constexpr uint64_t kMostStageCacheBytes = uint64_t{256} << 20;

class StageCache {
 public:
    /// $XDG_CACHE_HOME/placode/stages, else ~/.cache/placode/stages; empty where neither is known:
    /// nothing is kept then.
    [[nodiscard]] static std::filesystem::path folder_of_this_user();

    explicit StageCache(std::filesystem::path folder = folder_of_this_user(),
                        uint64_t most_bytes = kMostStageCacheBytes);

    /// @param task_json of the task, with its scene (curriculum::Task::json). Null: it is not
    /// there. Any thread.
    [[nodiscard]] std::shared_ptr<const curriculum::StageStart> find(const std::string& task_json,
                                                                     uint64_t seed,
                                                                     int stage) const noexcept;
    /// The state that a recorded attempt began with; it is to be compared with `header.given_hash`.
    [[nodiscard]] std::shared_ptr<const curriculum::StageStart> find(
        const sim::RecordingHeader& header) const noexcept;
    /// Keeps it, whole or not at all. False: it could not be kept, which costs time and nothing
    /// else.
    bool keep(const std::string& task_json, uint64_t seed,
              const curriculum::StageStart& start) const noexcept;

    /// Where the file of this key is, or would be.
    [[nodiscard]] std::filesystem::path file_of(const std::string& task_json, uint64_t seed,
                                                int stage) const;

 private:
    void make_room(uint64_t for_bytes, const std::filesystem::path& own) const;

    std::filesystem::path folder_;
    uint64_t most_bytes_;
};

}  // namespace placode::db

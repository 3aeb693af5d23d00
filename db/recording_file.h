// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recording file: an SQLite file of its own, committed at least every 0.5 s while an attempt
// runs, zstd chunks inside. Whatever was committed survives a crash or a power cut.

#include <memory>
#include <string>

#include "sim/recording.h"

namespace placode::db {

/// Sink for one attempt, used by the recorder thread. Throws StoreError when the file exists or
/// cannot be written.
[[nodiscard]] std::unique_ptr<sim::RecordingSink> create_recording_file(const std::string& path);

/// Reads a whole file. A file without an end (crash) comes back with EndReason::kInterrupted and
/// the duration of what was committed. Throws StoreError(kDamaged) naming the chunk, or kTooNew.
[[nodiscard]] sim::Recording read_recording_file(const std::string& path);

/// Recording files in `folder` that nobody is writing to: left over from a crash. Sorted by name.
[[nodiscard]] std::vector<std::string> leftover_recordings(const std::string& folder);

}  // namespace placode::db

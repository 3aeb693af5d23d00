// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a check of the store says on its way, and how it is stopped: a large one takes long.

#include <cstdint>
#include <functional>

namespace placode::db {

struct CheckProgress {
    enum class Step : uint8_t { kFile, kTrail, kObjects, kRecordings };
    Step step = Step::kFile;
    int64_t done = 0;  ///< Entries of the trail, rows, recordings; of the file always 0.
};

struct CheckOptions {
    /// Asked often, while a file itself is looked at from another thread: true = stop.
    std::function<bool()> stop;
    /// Told now and then, in the thread of the check. May throw, to stop.
    std::function<void(const CheckProgress&)> progress;
};

/// Called before each entry, row or recording that a part of a check looks at. May throw, to stop.
using CheckPace = std::function<void(CheckProgress::Step)>;

}  // namespace placode::db

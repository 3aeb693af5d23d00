// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stored attempts under another rubric: computed again from their recordings, both scores kept.

#include <QTemporaryDir>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "db/store.h"

namespace placode::db {

enum class RescoreState : uint8_t {
    kRescored,      ///< A further score was saved (or would be).
    kAlreadyThere,  ///< Under this rubric, metric set and pre-processing it has a score.
    kNoRecording,
    kUnreadable,
    kNotComputed  ///< RescoreOptions::computed has no score of it.
};
[[nodiscard]] const char* rescore_state_name(RescoreState state);

struct RescoreOutcome {
    int64_t attempt_id = 0;
    RescoreState state = RescoreState::kRescored;
    double old_points = 0, new_points = 0;  ///< new: only where it was computed.
    assessment::Verdict old_verdict{}, new_verdict{};
    std::string problem;  ///< kUnreadable: why.
    /// Metrics that its recording was made too early for, or ended too abruptly.
    std::vector<std::string> lacks;
};

struct ComputedScore {
    RescoreRecord record;
    std::vector<std::string> lacks;  ///< As in RescoreOutcome.
};
/// A score that was computed elsewhere, of the recording in this file; nothing where there is none.
/// Throws StoreError kConflict when it is of another recording.
using ComputedScores =
    std::function<std::optional<ComputedScore>(int64_t attempt_id, const std::string& file)>;

struct RescoreOptions {
    int64_t user_id = 0;  ///< 0 = everybody's.
    bool dry_run = false;
    /// Told before each attempt; false stops, what is done stays done.
    std::function<bool(size_t done, size_t total)> progress;
    ComputedScores computed;      ///< Kept instead of computing here; empty = compute.
    std::set<int64_t> recompute;  ///< Attempts whose computed score is compared with our own.
};

/// The recording file of a stored attempt, for as long as it is looked at.
struct ExtractedRecording {
    ExtractedRecording(Store& store, int64_t attempt_id);  ///< Throws StoreError.
    QTemporaryDir folder;
    std::string path;
};

/// The recording of a stored attempt. Throws StoreError.
[[nodiscard]] sim::Recording stored_recording(Store& store, int64_t attempt_id);

/// All attempts of the task under its rubric. Publishes the rubric's text (not in a dry run), so
/// that its version means one text for good. Throws kConflict when this version has another text.
/// Attempts that already have a score under it are left alone, except in a dry run, which computes
/// them too: the same recording and rubric must give the same score. Throws kConflict, with nothing
/// saved, when a score that was computed elsewhere is not the one that this computer finds.
[[nodiscard]] std::vector<RescoreOutcome> rescore(Store& store, const curriculum::Task& task,
                                                  const RescoreOptions& options);

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the store says of an attempt beside what its recording says: whoever writes rows writes
// their points, too. Values are told by the names of the store's columns.

#include <optional>
#include <string>

#include "db/records.h"
#include "db/said.h"

namespace placode::db {

/// Task, case, time, device and end, which every program of whatever version reads alike. nullopt:
/// they are the recording's.
[[nodiscard]] std::optional<Said> facts_that_differ(const AttemptDetail& kept,
                                                    const sim::Recording& recording);

enum class ScoreComparison : uint8_t {
    kSame,
    kDiffers,
    kOfAnother  ///< An earlier version of this program scored it, and now the points are others.
};
struct ComparedScore {
    ScoreComparison outcome = ScoreComparison::kSame;
    Said difference;  ///< kDiffers: which value first.
};
/// Points, verdict, metrics, reasons, events and what makes an attempt void.
/// @param found as db::judged() made it of the recording by the published rubric, with exam and
/// recording file filled in. Throws StoreError where the recording cannot be read just now.
[[nodiscard]] ComparedScore compare_score(const AttemptDetail& kept, const AttemptResult& found);

/// Name and values of the first difference between two scores of one attempt, "" for none.
[[nodiscard]] std::string score_difference(const assessment::MetricSet& metrics,
                                           const assessment::Score& score,
                                           const assessment::MetricSet& other_metrics,
                                           const assessment::Score& other);

}  // namespace placode::db

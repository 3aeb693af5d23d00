// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Standard setting from what is in the store: levels of people, bands, pass marks, and how good a
// metric is.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metric_quality.h"
#include "assessment/standard_setting.h"
#include "db/store.h"

namespace placode::db {

/// Attempts of one level, by person, in order of time. All are of the newest metric set and
/// pre-processing among them; interrupted and generated attempts are left out.
struct LevelAttempts {
    std::string level;
    std::map<int64_t, std::vector<MeasuredAttempt>> by_person;
    int left_out = 0;  ///< Of older versions.
    [[nodiscard]] int attempts() const;
    [[nodiscard]] int passed() const;  ///< Of these attempts.
};
/// @param people account ids by level.
[[nodiscard]] std::vector<LevelAttempts> level_attempts(
    Store& store, const std::string& task_id,
    const std::map<std::string, std::vector<int64_t>>& people);

/// Others are judged by what comes of these: what people did is in it once it was simulated again
/// with the same outcome. Throws StoreError(kRefused) that says how many never were. A
/// demonstration need not be; whoever makes something of it says that it is one.
void need_proof(const std::vector<LevelAttempts>& levels);

/// As need_same_rules() of db/attempt_counting.h, over all these attempts.
void need_same_rules(const std::vector<LevelAttempts>& levels);

/// For what real people are judged by: demonstrations stay only where all accounts are there to
/// demonstrate.
void leave_demonstrations_out(Store& store, std::vector<LevelAttempts>& levels);

/// Higher for "points"; neutral for what is no metric.
[[nodiscard]] assessment::Direction direction_of(const std::string& metric);

/// "points" or a metric's id. Nothing where the attempt has no such value.
[[nodiscard]] std::optional<double> value_of(const MeasuredAttempt& attempt,
                                             const std::string& metric);

/// Mean of each person's attempts (per_person), or each attempt.
[[nodiscard]] std::vector<double> level_values(const LevelAttempts& level,
                                               const std::string& metric, bool per_person);

/// Pass mark of a metric, or "points", by contrasting groups, whichever way the metric goes.
/// @param per_person  As in level_values(). Throws as assessment::contrasting_groups().
[[nodiscard]] assessment::ContrastingGroups pass_mark_between(const LevelAttempts& novices,
                                                              const LevelAttempts& experts,
                                                              const std::string& metric,
                                                              bool per_person);

/// Bands of every level and metric, of persons' means. Throws StoreError(kRefused) naming a level
/// with fewer than `least` persons (never below curriculum::kLeastNormGroup), or mixed rubrics.
[[nodiscard]] curriculum::NormPack make_norms(const std::vector<LevelAttempts>& levels,
                                              const std::string& centre,
                                              const std::string& made_utc, int least);

/// Signs with the centre's key, which its passphrase opens, and keeps the pack. The key is made
/// when it is missing, and sealed when it lies in clear (Norms::open_centre_key, which it throws
/// as).
int64_t keep_own_norms(Store& store, const curriculum::NormPack& pack, std::string_view passphrase);

/// The pack in use for a task, if there is one.
[[nodiscard]] std::optional<NormPackRecord> norms_in_use(Store& store, const std::string& task_id);

/// An attempt's metric against a band.
struct BandComparison {
    std::string metric;
    double value = 0;
    assessment::Benchmark band;
    std::optional<double> z, score;  ///< Absent for a neutral metric or a band that does not vary.
};
[[nodiscard]] std::vector<BandComparison> compare_with_band(const MeasuredAttempt& attempt,
                                                            const curriculum::NormGroup& group);

/// Quality of every metric that an attempt of either level has, "points" first.
[[nodiscard]] std::vector<assessment::MetricQuality> metric_panel(const LevelAttempts& novices,
                                                                  const LevelAttempts& experts,
                                                                  int repeats);

}  // namespace placode::db

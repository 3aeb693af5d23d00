// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is stuck and who regressed: a plain rule over runs of three attempts, for an educator's list.
// The rule is this project's; it points at people to look at, it does not judge them.

#include <cstdint>
#include <span>

namespace placode::assessment {

inline constexpr int kTrendRun = 3;       ///< Attempts that are averaged.
inline constexpr double kTrendDrop = 10;  ///< Points below the best run that count as regress.
inline constexpr double kTrendGain = 3;   ///< Points from run to run below which nothing moves.

enum class TrendKind : uint8_t {
    kTooFew,       ///< Fewer than two runs, and not regressed or at the benchmark.
    kAtBenchmark,  ///< The last run is at the benchmark or above.
    kImproving,
    kStuck,     ///< Below the benchmark, and the last run is no better than the one before.
    kRegressed  ///< The last run is kTrendDrop or more below the best one.
};
[[nodiscard]] const char* trend_name(TrendKind kind);

struct Trend {
    TrendKind kind = TrendKind::kTooFew;
    double recent = 0;  ///< Mean of the last run (of all while there are fewer).
    double best = 0;    ///< Largest mean of a run of successive attempts.
    double gain = 0;    ///< Last run against the one before it; 0 below two runs.
};

/// @param points of one person in one task, oldest first.
[[nodiscard]] Trend trend(std::span<const double> points, double benchmark);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/trend.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace placode::assessment {
namespace {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

const char* trend_name(TrendKind kind) {
    constexpr std::array<const char*, 5> kNames{"too few", "at benchmark", "improving", "stuck",
                                                "regressed"};
    return kNames[static_cast<size_t>(kind)];
}

Trend trend(std::span<const double> points, double benchmark) {
    Trend found;
    if (points.empty()) return found;
    const size_t run = std::min<size_t>(kTrendRun, points.size());
    found.recent = mean(points.last(run));
    found.best = found.recent;
    for (size_t i = 0; i + run <= points.size(); ++i)
        found.best = std::max(found.best, mean(points.subspan(i, run)));
    if (points.size() >= 2 * kTrendRun)
        found.gain = found.recent - mean(points.subspan(points.size() - 2 * kTrendRun, kTrendRun));
    if (points.size() < kTrendRun) return found;
    if (found.best - found.recent >= kTrendDrop)
        found.kind = TrendKind::kRegressed;
    else if (found.recent >= benchmark)
        found.kind = TrendKind::kAtBenchmark;
    else if (points.size() < 2 * kTrendRun)
        found.kind = TrendKind::kTooFew;
    else
        found.kind = found.gain < kTrendGain ? TrendKind::kStuck : TrendKind::kImproving;
    return found;
}

}  // namespace placode::assessment

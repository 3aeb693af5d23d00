// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metric_quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "assessment/rank_tests.h"
#include "assessment/reliability.h"
#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

constexpr double kLeastIcc = 0.5;           // "moderate" begins here: Koo & Li 2016.
constexpr double kMostCeilingPercent = 20;  // Floor and ceiling effects: Terwee et al. 2007 say 15.

std::vector<double> finite(const std::vector<double>& values) {
    std::vector<double> kept;
    for (const double v : values)
        if (std::isfinite(v)) kept.push_back(v);
    return kept;
}

void compare_levels(MetricQuality& quality, double sign, const std::vector<Repeats>& people) {
    std::vector<double> novices, experts;
    for (const Repeats& person : people) {
        const auto mean = mean_of(finite(person.values));
        if (mean) (person.level == 0 ? novices : experts).push_back(sign * *mean);
    }
    quality.novices = static_cast<int>(novices.size());
    quality.experts = static_cast<int>(experts.size());
    if (novices.size() < 2 || experts.size() < 2) return;
    const MannWhitney test = mann_whitney(experts, novices);
    quality.cliff_delta = test.cliffs_delta;
    // Without spread within the levels a standardised difference is no number.
    const bool varies = sample_sd(novices).value_or(0) > 0 || sample_sd(experts).value_or(0) > 0;
    if (!varies || !std::isfinite(test.hedges_g)) return;
    quality.g = test.hedges_g;
    quality.g_low = test.hedges_g_ci95.low;
    quality.g_high = test.hedges_g_ci95.high;
    quality.separates = *quality.g_low > 0;
}

void compare_repeats(MetricQuality& quality, const std::vector<Repeats>& people) {
    Scores rows;
    for (const Repeats& person : people) {
        std::vector<double> row = finite(person.values);
        if (static_cast<int>(row.size()) < quality.repeats) continue;
        row.resize(static_cast<size_t>(quality.repeats));
        rows.push_back(std::move(row));
    }
    quality.repeated = static_cast<int>(rows.size());
    if (rows.size() < 2) return;
    // Without any spread within people there is nothing to estimate: 1 where people differ.
    const auto same = [](const std::vector<double>& row) {
        return std::all_of(row.begin(), row.end(), [&](double v) { return v == row.front(); });
    };
    const bool people_differ = std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
        return row.front() != rows.front().front();
    });
    if (std::all_of(rows.begin(), rows.end(), same)) {
        if (people_differ) quality.icc = quality.icc_low = quality.icc_high = 1;
    } else {
        try {
            const Icc icc = intraclass_correlation(rows);
            if (std::isfinite(icc.icc2.icc)) {
                quality.icc = icc.icc2.icc;
                quality.icc_low = icc.icc2.ci95.low;
                quality.icc_high = icc.icc2.ci95.high;
            }
        } catch (const std::invalid_argument&) {
            // People's means or what remains do not vary: no estimate.
        }
    }
    quality.repeatable = quality.icc && *quality.icc >= kLeastIcc;
}

void find_ceiling(MetricQuality& quality, double sign, const std::vector<Repeats>& people) {
    std::vector<double> all;
    for (const Repeats& person : people)
        for (const double v : finite(person.values)) all.push_back(sign * v);
    if (all.empty()) return;
    const double best = *std::max_element(all.begin(), all.end());
    const auto at_best = std::count(all.begin(), all.end(), best);
    quality.ceiling_percent =
        100.0 * static_cast<double>(at_best) / static_cast<double>(all.size());
    // One value of a few is always the best: a ceiling takes two at least.
    quality.ceiling = at_best > 1 && *quality.ceiling_percent > kMostCeilingPercent;
}

std::string reasons(const MetricQuality& quality) {
    std::string why;
    const auto add = [&](const std::string& text) { why += (why.empty() ? "" : "; ") + text; };
    if (!quality.g)
        add(quality.novices < 2 || quality.experts < 2
                ? "fewer than 2 novices or experts have a value"
                : "no spread within the levels");
    else if (!quality.separates)
        add("the levels do not differ for certain");
    if (!quality.icc)
        add(quality.repeated < 2 ? "fewer than 2 people have enough repeats"
                                 : "no spread between people");
    else if (!quality.repeatable)
        add("repeats of the same person differ too much");
    if (quality.ceiling) add("too many values are at the best one");
    return why;
}

}  // namespace

MetricQuality metric_quality(const std::string& metric, Direction direction,
                             const std::vector<Repeats>& people, int repeats) {
    assert(repeats >= 2);
    MetricQuality quality;
    quality.metric = metric;
    quality.repeats = repeats;
    // A neutral metric has no better side: high is taken, and the sign of g says which.
    const double sign = direction == Direction::kLowerIsBetter ? -1 : 1;
    compare_levels(quality, sign, people);
    compare_repeats(quality, people);
    find_ceiling(quality, sign, people);
    quality.evidence = quality.separates && quality.repeatable && !quality.ceiling;
    quality.why = reasons(quality);
    return quality;
}

}  // namespace placode::assessment

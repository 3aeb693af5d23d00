// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Objective measures of one attempt: pure functions of a recording.
// Definitions with sources: docs/training.md, "Metrics"; every metric knows its unit and direction.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/step/recording.h"

namespace placode::assessment {

/// 12: a slit under pressure. 13: how hard a thread was drawn. 14: how a patch lies. 15: how a
/// field was washed. 16: how far skin is undermined.
/// 17: skin burned anywhere; one value for each stretch of a traced line and each target.
/// 18: what lasts counts more, a line traced far off, energy into healthy skin.
/// 19: taps on one spot or in air are one spell, tugs one pull; a traced line is weighed by the
/// way. 20: a bite through a slit from its entry.
/// 21: healthy skin that leaves with a piece is torn; wire and thread touch the placode.
/// 22: where a slit leaks; how a needle goes from hand to hand.
/// 23: a bite of a row counts from its entry on, finished or not, and is done while its thread is
/// in it; a single one has its own angle. What two hands do to a needle counts in any case.
inline constexpr int kMetricSetVersion = 23;

enum class Direction : uint8_t { kLowerIsBetter, kHigherIsBetter, kNeutral };

/// What a metric is; the same for every attempt.
struct MetricDefinition {
    std::string_view id;    ///< Key with unit, e.g. "path_length_mm".
    std::string_view name;  ///< English display name; translated in ui.
    std::string_view unit;
    Direction direction = Direction::kLowerIsBetter;
    std::string_view definition;  ///< One sentence.
    std::string_view source;
};
[[nodiscard]] std::span<const MetricDefinition> metric_definitions();
/// nullptr for an unknown id.
[[nodiscard]] const MetricDefinition* metric_definition(std::string_view id);

struct Metric {
    std::string id;
    double value = 0;
};

/// Values of one attempt, in the order of metric_definitions(); a metric that cannot be computed
/// (no movement, no needle) is absent.
struct MetricSet {
    int version = kMetricSetVersion;
    std::vector<Metric> values;
    [[nodiscard]] std::optional<double> find(std::string_view id) const;
};

/// All metrics that the recording allows. Never throws on odd data.
[[nodiscard]] MetricSet compute_metrics(const sim::Recording& recording);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The metrics that the columns of a signal file allow.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/signal_file.h"

namespace placode::assessment {

struct SignalOptions {
    bool raw = false;                   ///< No filter, no resampling: the signal is clean already.
    std::optional<double> threshold_n;  ///< Force: what counts as too much [N].
    double movement_threshold_mm_s = 20;  ///< Speed at which a movement begins.
    double idle_threshold_mm_s = 5;       ///< Slower is idle.
    double bimanual_threshold_mm_s = 40;  ///< Two hands: from here on a hand moves.
};

struct SignalMetrics {
    std::vector<std::pair<std::string, double>> values;  ///< Key with unit, in a fixed order.
    std::vector<std::string> columns_not_used;           ///< Nothing is computed from them.
};

/// Every metric that the columns allow, in whatever order they stand. Throws SignalError where
/// there is nothing that it knows, and for values that cannot be.
[[nodiscard]] SignalMetrics signal_metrics(const SignalFile& file, const SignalOptions& options);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A signal in a CSV file whose header carries the units, and the metrics that its columns allow.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placode::cli {

struct SignalFile {
    std::string path;
    std::vector<std::string> columns;
    std::vector<std::vector<double>> values;  ///< (column x row)
};

/// Throws InputError naming file, line, column, what was found and what is expected.
[[nodiscard]] SignalFile read_signal_file(const std::string& path);

struct SignalOptions {
    bool raw = false;                   ///< No filter, no resampling: the signal is clean already.
    std::optional<double> threshold_n;  ///< Force: what counts as too much [N].
    double movement_threshold_mm_s = 20;  ///< Speed at which a movement begins.
    double idle_threshold_mm_s = 5;       ///< Slower is idle.
};

/// Key with unit and value, in a fixed order. Throws InputError for columns it does not know.
[[nodiscard]] std::vector<std::pair<std::string, double>> signal_metrics(
    const SignalFile& file, const SignalOptions& options);

}  // namespace placode::cli

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of numbers in a CSV file whose header carries the units.

#include <string>
#include <vector>

namespace placode::cli {

struct SignalFile {
    std::string path;
    std::vector<std::string> columns;
    std::vector<std::vector<double>> values;  ///< (column x row)
};

/// Throws InputError naming file, line, column, what was found and what is expected.
[[nodiscard]] SignalFile read_signal_file(const std::string& path);

/// Column names with commas between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace placode::cli

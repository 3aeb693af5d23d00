// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of numbers in a CSV file whose header carries the units.

#include <stdexcept>
#include <string>
#include <vector>

namespace placode::assessment {

/// A signal that cannot be used: file, line, column, what was found and what is expected.
class SignalError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

struct SignalFile {
    std::string path;
    std::vector<std::string> columns;
    std::vector<std::vector<double>> values;  ///< (column x row)
    std::vector<int> lines;                   ///< Of the file, for each row.
    [[nodiscard]] int line(size_t row) const { return lines.at(row); }
};

/// Throws SignalError.
[[nodiscard]] SignalFile read_signal_file(const std::string& path);

/// Removes rows whose first column repeats that of the row before; returns how many.
int drop_repeated_times(SignalFile& file);

/// Column names with commas between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables as spreadsheets save them: RFC 4180, with or without a byte order mark, any line ends.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace placode::assessment {

/// What is wrong with a table: "line 3, column 2: found ...; expected ...".
class CsvError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// One row; the first is the head.
struct CsvRow {
    std::vector<std::string> cells;
    int line = 1;  ///< Of the text, where the row begins: a quoted cell may hold line ends.
};

/// All rows. An empty line is a row of one empty cell. A quote inside a cell that did not begin
/// with one stands for itself. Throws CsvError when a quote is not closed, or text follows one that
/// is.
[[nodiscard]] std::vector<CsvRow> read_csv(std::string_view text, char separator = ',');

/// Throws CsvError when the head is that of a table with another separator, which spreadsheets save
/// where ',' is the decimal sign: what is wrong with its rows would lead nobody there.
void need_commas(const std::vector<CsvRow>& rows);

/// Removes empty lines: before the head and at the end always, elsewhere unless the table has one
/// column, where an empty line is an empty cell.
void leave_out_empty_lines(std::vector<CsvRow>& rows);

}  // namespace placode::assessment

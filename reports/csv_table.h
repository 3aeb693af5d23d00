// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Comma-separated text, RFC 4180: UTF-8, '.' decimals, cells that a spreadsheet would run as a
// formula neutralised, and read back to what they were.

#include <string>
#include <vector>

namespace placode::reports {

/// Text that a person typed. A leading = + - @ tab or return would run as a formula, so it gets an
/// apostrophe in front; so does text that already looks like that, so that it can be undone. The
/// same after each semicolon, tab and line end, where a program may begin a cell of its own.
[[nodiscard]] std::string harmless(const std::string& text);
/// Undoes harmless().
[[nodiscard]] std::string as_typed(const std::string& cell);

/// One line with its end; cells are quoted where they need it.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells, char separator = ',');

/// The cells of assessment::read_csv(), the head too. Throws ReportError.
[[nodiscard]] std::vector<std::vector<std::string>> parse_csv(const std::string& text,
                                                              char separator = ',');

}  // namespace placode::reports

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv_table.h"

#include <string_view>

#include "assessment/csv_reader.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

/// Where a program may begin a new cell: with lists that are separated by semicolons (as in
/// Poland), the text "x;=1" of one cell is two, and the second one a formula.
constexpr std::string_view kCellEnds = ";\t\n\r";

/// What follows is run: = + - @ tab return, maybe behind quotes that a program takes off.
bool looks_like_a_formula(std::string_view text) {
    const size_t at = text.find_first_not_of("'\"");
    return at != std::string_view::npos &&
           std::string_view("=+-@\t\r").find(text[at]) != std::string_view::npos;
}

/// The places where a cell may begin, in order: the first one is 0.
std::vector<size_t> cell_begins(const std::string& text) {
    std::vector<size_t> begins{0};
    for (size_t at = text.find_first_of(kCellEnds); at != std::string::npos;
         at = text.find_first_of(kCellEnds, at + 1))
        begins.push_back(at + 1);
    return begins;
}

}  // namespace

std::string harmless(const std::string& text) {
    std::string safe = text;
    const std::vector<size_t> begins = cell_begins(text);
    for (auto at = begins.rbegin(); at != begins.rend(); ++at)  // From the end: places stay.
        if (looks_like_a_formula(std::string_view(text).substr(*at))) safe.insert(*at, 1, '\'');
    return safe;
}

std::string as_typed(const std::string& cell) {
    std::string typed = cell;
    const std::vector<size_t> begins = cell_begins(cell);
    for (auto at = begins.rbegin(); at != begins.rend(); ++at)
        if (*at < cell.size() && cell[*at] == '\'' &&
            looks_like_a_formula(std::string_view(cell).substr(*at)))
            typed.erase(*at, 1);
    return typed;
}

std::string csv_line(const std::vector<std::string>& cells, char separator) {
    std::string line;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += separator;
        const std::string& cell = cells[i];
        if (cell.find_first_of("\"\n\r") == std::string::npos &&
            cell.find(separator) == std::string::npos) {
            line += cell;
            continue;
        }
        line += '"';
        for (const char c : cell) {
            if (c == '"') line += '"';
            line += c;
        }
        line += '"';
    }
    return line + '\n';
}

std::vector<std::vector<std::string>> parse_csv(const std::string& text, char separator) {
    std::vector<std::vector<std::string>> rows;
    try {
        for (auto& row : assessment::read_csv(text, separator))
            rows.push_back(std::move(row.cells));
    } catch (const assessment::CsvError& error) {
        throw ReportError(std::string("read CSV: ") + error.what());
    }
    return rows;
}

}  // namespace placode::reports

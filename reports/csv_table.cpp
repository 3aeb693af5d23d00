// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv_table.h"

#include "assessment/csv_reader.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

bool looks_like_a_formula(const std::string& text) {
    const size_t at = text.find_first_not_of('\'');
    if (at == std::string::npos) return false;
    return std::string("=+-@\t\r").find(text[at]) != std::string::npos;
}

}  // namespace

std::string harmless(const std::string& text) {
    return looks_like_a_formula(text) ? '\'' + text : text;
}

std::string as_typed(const std::string& cell) {
    return !cell.empty() && cell[0] == '\'' && looks_like_a_formula(cell) ? cell.substr(1) : cell;
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

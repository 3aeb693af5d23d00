// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/signal_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "assessment/csv_reader.h"
#include "sim/core/text_file.h"

namespace placode::assessment {
namespace {

std::vector<CsvRow> rows_of(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw SignalError(path + ": this is a folder; expected a CSV file");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw SignalError(path + ": cannot be read; expected a CSV file");
    const auto text = sim::read_at_most(in, sim::kLargestTable);
    if (!text) throw SignalError(path + ": has more than 1 GB; expected a CSV file of less");
    try {
        auto rows = read_csv(*text);
        need_commas(rows);
        if (rows.empty()) rows.push_back({{""}, 1});  // no column at all is said by the caller
        return rows;
    } catch (const CsvError& error) {
        throw SignalError(path + ": " + error.what());
    }
}

/// Without the blanks around it, which tables for people have.
std::string trimmed(std::string cell) {
    cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
    cell.erase(cell.find_last_not_of(" \t") + 1);
    return cell;
}

double parse(const std::string& cell, const std::string& place) {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto [rest, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc{} || rest != end || !std::isfinite(value))
        throw SignalError(place + ": found \"" + cell +
                          "\"; expected a number with '.' as decimal sign");
    return value;
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
    return text;
}

SignalFile read_signal_file(const std::string& path) {
    const auto rows = rows_of(path);
    SignalFile file;
    file.path = path;
    for (const std::string& name : rows[0].cells) file.columns.push_back(trimmed(name));
    file.values.resize(file.columns.size());
    for (size_t r = 1; r < rows.size(); ++r) {
        const auto& cells = rows[r].cells;
        if (cells.size() == 1 && cells[0].empty()) continue;
        const std::string place = path + ":" + std::to_string(rows[r].line);
        if (cells.size() != file.columns.size())
            throw SignalError(place + ": found " + std::to_string(cells.size()) +
                              " columns; expected " + std::to_string(file.columns.size()) + " (" +
                              joined(file.columns) + ")");
        for (size_t i = 0; i < cells.size(); ++i)
            file.values[i].push_back(parse(trimmed(cells[i]), place + ": " + file.columns[i]));
        file.lines.push_back(rows[r].line);
    }
    return file;
}

int drop_repeated_times(SignalFile& file) {
    size_t kept = 0;
    for (size_t row = 0; row < file.lines.size(); ++row) {
        if (kept > 0 && file.values[0][row] == file.values[0][kept - 1]) continue;
        for (auto& column : file.values) column[kept] = column[row];
        file.lines[kept++] = file.lines[row];
    }
    const auto dropped = static_cast<int>(file.lines.size() - kept);
    for (auto& column : file.values) column.resize(kept);
    file.lines.resize(kept);
    return dropped;
}

}  // namespace placode::assessment

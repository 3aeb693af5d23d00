// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/signal_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

std::vector<std::string> split(std::string line) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells;
    size_t begin = 0;
    for (;;) {
        const size_t comma = line.find(',', begin);
        std::string cell = line.substr(begin, comma - begin);
        cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
        cell.erase(cell.find_last_not_of(" \t") + 1);
        cells.push_back(std::move(cell));
        if (comma == std::string::npos) return cells;
        begin = comma + 1;
    }
}

double parse(const std::string& cell, const std::string& place) {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto [rest, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc{} || rest != end || !std::isfinite(value))
        throw InputError(place + ": found \"" + cell +
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
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path + ": cannot be read; expected a CSV file");
    SignalFile file;
    file.path = path;
    std::string line;
    std::getline(in, line);
    if (line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);  // A byte order mark.
    file.columns = split(line);
    file.values.resize(file.columns.size());
    for (int number = 2; std::getline(in, line); ++number) {
        if (line.empty() || line == "\r") continue;
        const auto cells = split(line);
        const std::string place = path + ":" + std::to_string(number);
        if (cells.size() != file.columns.size())
            throw InputError(place + ": found " + std::to_string(cells.size()) +
                             " columns; expected " + std::to_string(file.columns.size()) + " (" +
                             joined(file.columns) + ")");
        for (size_t i = 0; i < cells.size(); ++i)
            file.values[i].push_back(parse(cells[i], place + ": " + file.columns[i]));
        file.lines.push_back(number);
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

}  // namespace placode::cli

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/stats_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace placode::cli {
namespace {

/// Splits CSV text into records; quoted cells may hold commas, quotes and line breaks.
std::vector<std::vector<std::string>> records(const std::string& text, const std::string& path) {
    std::vector<std::vector<std::string>> result;
    std::vector<std::string> row;
    std::string cell;
    bool quoted = false;
    const auto end_row = [&] {
        row.push_back(cell);
        cell.clear();
        result.push_back(row);
        row.clear();
    };
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c != '"')
                cell += c;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                cell += text[++i];
            else
                quoted = false;
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            row.push_back(cell);
            cell.clear();
        } else if (c == '\n') {
            end_row();
        } else if (c != '\r') {
            cell += c;
        }
    }
    if (quoted)
        throw InputError(path +
                         ": a quoted cell is not closed; expected a \" before the end of the file");
    if (!cell.empty() || !row.empty()) end_row();
    // An empty line says nothing, except in a table of one column, where it is a missing value;
    // empty lines at the end are never one.
    const auto empty = [](const std::vector<std::string>& line) {
        return line.size() == 1 && line[0].empty();
    };
    while (!result.empty() && empty(result.back())) result.pop_back();
    while (!result.empty() && empty(result.front())) result.erase(result.begin());
    if (!result.empty() && result.front().size() > 1) std::erase_if(result, empty);
    return result;
}

constexpr double kLargest = 1e100;
constexpr int kWidestScale = 1000;  ///< Every value of it is counted.

bool is_missing(const std::string& cell) {
    return cell.empty() || cell == "NA" || cell == "NaN" || cell == "nan";
}

}  // namespace

size_t StatsTable::column(const std::string& name) const {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found != header.end()) return static_cast<size_t>(found - header.begin());
    std::string there;
    for (const std::string& other : header) there += (there.empty() ? "" : ", ") + other;
    throw InputError(path + ": line 1: there is no column \"" + name + "\"; the columns are " +
                     there);
}

bool StatsTable::has(const std::string& name) const {
    return std::find(header.begin(), header.end(), name) != header.end();
}

std::optional<double> StatsTable::number(size_t row, size_t column) const {
    const std::string& cell = rows[row][column];
    if (is_missing(cell)) return std::nullopt;
    double value = 0;
    const char* begin = cell.data() + (cell[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        throw InputError(path + ": line " + std::to_string(row + 2) + ", column " + header[column] +
                         ": found \"" + cell +
                         "\", expected a number with '.' (empty or NA when missing)");
    }
    if (std::abs(value) > kLargest) {
        throw InputError(path + ": line " + std::to_string(row + 2) + ", column " + header[column] +
                         ": found " + cell +
                         ", expected a number of at most 1e100: squares of larger ones are none");
    }
    return value;
}

double StatsTable::needed(size_t row, size_t column) const {
    if (const auto value = number(row, column)) return *value;
    throw InputError(path + ": line " + std::to_string(row + 2) + ", column " + header[column] +
                     ": a number is missing here");
}

StatsTable read_stats_table(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError("read " + path + ": the file cannot be opened; check name and rights");
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (text.rfind("\xef\xbb\xbf", 0) == 0) text.erase(0, 3);
    auto all = records(text, path);
    if (all.size() < 2)
        throw InputError(path +
                         ": expected a line with column names and at least one line of data");
    StatsTable table{path, all.front(), {all.begin() + 1, all.end()}};
    for (size_t i = 0; i < table.rows.size(); ++i) {
        if (table.rows[i].size() == table.header.size()) continue;
        throw InputError(path + ": line " + std::to_string(i + 2) + ": found " +
                         std::to_string(table.rows[i].size()) + " cells, expected " +
                         std::to_string(table.header.size()) + " as in the header");
    }
    return table;
}

Scale scale_of(const StatsTable& table, const StatsOptions& options) {
    if (!options.scale.empty()) {
        Scale scale;
        const size_t colon = options.scale.find(':');
        const char *text = options.scale.data(), *end = text + options.scale.size();
        const auto low = std::from_chars(text, end, scale.low);
        const auto high =
            colon == std::string::npos ? low : std::from_chars(text + colon + 1, end, scale.high);
        if (colon == std::string::npos || low.ec != std::errc() || high.ec != std::errc() ||
            low.ptr != text + colon || high.ptr != end || scale.low >= scale.high) {
            throw InputError("--scale: found \"" + options.scale +
                             "\", expected LOW:HIGH, e.g. 1:5");
        }
        if (static_cast<int64_t>(scale.high) - scale.low > kWidestScale)
            throw InputError("--scale: found \"" + options.scale + "\", expected at most " +
                             std::to_string(kWidestScale) + " steps between LOW and HIGH");
        return scale;
    }
    double low = INFINITY, high = -INFINITY;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        for (size_t column = 0; column < table.header.size(); ++column) {
            const auto value = table.number(row, column);
            if (!value) continue;
            low = std::min(low, *value);
            high = std::max(high, *value);
        }
    }
    if (!(low < high))
        throw InputError(table.path + ": all answers are equal; give the scale, e.g. --scale 1:5");
    if (high - low > kWidestScale || std::max(std::abs(low), std::abs(high)) > 1e9)
        throw InputError(table.path + ": answers lie between " + shortest(low) + " and " +
                         shortest(high) + "; give the scale, e.g. --scale 1:5");
    return {static_cast<int>(low), static_cast<int>(high)};
}

CompleteCases complete_cases(const StatsTable& table, const StatsOptions& options) {
    CompleteCases cases;
    cases.items = table.header;
    std::vector<std::string> reverse_keyed;
    std::stringstream names(options.reverse);
    for (std::string item; std::getline(names, item, ',');) {
        (void)table.column(item);  // names the columns when it is not there
        reverse_keyed.push_back(item);
    }
    const Scale scale = options.reverse.empty() ? Scale{} : scale_of(table, options);
    for (size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double> scores;
        for (size_t column = 0; column < table.header.size(); ++column) {
            const auto value = table.number(row, column);
            if (!value) break;
            const bool reverse = std::find(reverse_keyed.begin(), reverse_keyed.end(),
                                           table.header[column]) != reverse_keyed.end();
            scores.push_back(reverse ? assessment::reversed(*value, scale.low, scale.high)
                                     : *value);
        }
        if (scores.size() == table.header.size())
            cases.scores.push_back(scores);
        else
            ++cases.missing;
    }
    if (cases.scores.empty()) throw InputError(table.path + ": no row is complete");
    return cases;
}

void leave_out_constant(CompleteCases& cases) {
    for (size_t item = cases.items.size(); item-- > 0;) {
        const bool constant =
            std::all_of(cases.scores.begin(), cases.scores.end(),
                        [&](const auto& row) { return row[item] == cases.scores[0][item]; });
        if (!constant) continue;
        cases.constant.insert(cases.constant.begin(), cases.items[item]);
        cases.items.erase(cases.items.begin() + static_cast<long>(item));
        for (auto& row : cases.scores) row.erase(row.begin() + static_cast<long>(item));
    }
}

std::vector<assessment::NamedGroup> groups_of(const StatsTable& table, const StatsOptions& options,
                                              int& missing) {
    const auto pick = [&](const std::string& asked, std::initializer_list<const char*> usual) {
        if (!asked.empty()) return table.column(asked);
        for (const char* name : usual) {
            if (table.has(name)) return table.column(name);
        }
        return table.column(*usual.begin());
    };
    const size_t value = pick(options.value, {"value", "score"}), by = pick(options.by, {"group"});
    std::map<std::string, std::vector<double>> values;
    missing = 0;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const auto number = table.number(row, value);
        const std::string& group = table.rows[row][by];
        if (!number || is_missing(group))
            ++missing;
        else
            values[group].push_back(*number);
    }
    std::vector<assessment::NamedGroup> groups;
    for (const auto& [name, numbers] : values) groups.push_back({name, numbers});
    return groups;
}

Json interval(const assessment::Interval& interval) {
    return Json::array({interval.low, interval.high});
}

}  // namespace placode::cli

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/stats_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "assessment/csv_reader.h"
#include "sim/core/text_file.h"

namespace placode::cli {
namespace {

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

std::string StatsTable::place(size_t row, size_t column) const {
    return path + ": line " + std::to_string(lines[row]) + ", column " + header[column];
}

std::optional<double> StatsTable::number(size_t row, size_t column) const {
    const std::string& cell = rows[row][column];
    if (is_missing(cell)) return std::nullopt;
    double value = 0;
    const char* begin = cell.data() + (cell[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        throw InputError(place(row, column) + ": found \"" + cell +
                         "\", expected a number with '.' (empty or NA when missing)");
    }
    if (std::abs(value) > kLargest) {
        throw InputError(place(row, column) + ": found " + cell +
                         ", expected a number of at most 1e100: squares of larger ones are none");
    }
    return value;
}

double StatsTable::needed(size_t row, size_t column) const {
    if (const auto value = number(row, column)) return *value;
    throw InputError(place(row, column) + ": a number is missing here");
}

StatsTable read_stats_table(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))  // It can be opened as a file can.
        throw InputError("read " + path + ": this is a folder; expected a CSV file");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError("read " + path + ": the file cannot be opened; check name and rights");
    const auto text = sim::read_at_most(in, sim::kLargestTable);
    if (!text) throw InputError("read " + path + ": the file has more than 1 GB; expected less");
    std::vector<assessment::CsvRow> all;
    try {
        all = assessment::read_csv(*text);
        assessment::leave_out_empty_lines(all);
        assessment::need_commas(all);
    } catch (const assessment::CsvError& error) {
        throw InputError(path + ": " + error.what());
    }
    if (all.size() < 2)
        throw InputError(path +
                         ": expected a line with column names and at least one line of data");
    StatsTable table{path, all.front().cells, {}, {}};
    for (size_t i = 1; i < all.size(); ++i) {
        if (all[i].cells.size() != table.header.size())
            throw InputError(path + ": line " + std::to_string(all[i].line) + ": found " +
                             std::to_string(all[i].cells.size()) + " cells, expected " +
                             std::to_string(table.header.size()) + " as in the header");
        table.rows.push_back(std::move(all[i].cells));
        table.lines.push_back(all[i].line);
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

CompleteCases complete_cases(const StatsTable& table, const StatsOptions& options,
                             const std::optional<Scale>& scale) {
    CompleteCases cases;
    cases.items = table.header;
    std::vector<std::string> reverse_keyed;
    std::stringstream names(options.reverse);
    for (std::string item; std::getline(names, item, ',');) {
        (void)table.column(item);  // names the columns when it is not there
        reverse_keyed.push_back(item);
    }
    Scale ends;
    if (!options.reverse.empty()) ends = scale ? *scale : scale_of(table, options);
    for (size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double> scores;
        for (size_t column = 0; column < table.header.size(); ++column) {
            const auto value = table.number(row, column);
            if (!value) break;
            const bool reverse = std::find(reverse_keyed.begin(), reverse_keyed.end(),
                                           table.header[column]) != reverse_keyed.end();
            scores.push_back(reverse ? assessment::reversed(*value, ends.low, ends.high) : *value);
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

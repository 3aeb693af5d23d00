// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads the tables and expected values of tests/data/statistics.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "assessment/csv_reader.h"

namespace placode::tests {

struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> columns;

    [[nodiscard]] size_t rows() const { return columns.empty() ? 0 : columns[0].size(); }
    [[nodiscard]] const std::vector<std::string>& column(const std::string& name) const {
        for (size_t i = 0; i < header.size(); ++i) {
            if (header[i] == name) return columns[i];
        }
        throw std::runtime_error("no column " + name);
    }
    [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
        std::vector<double> result;
        for (const std::string& cell : column(name)) result.push_back(std::stod(cell));
        return result;
    }
    [[nodiscard]] std::vector<double> group(const std::string& value, const std::string& by,
                                            const std::string& name) const {
        std::vector<double> result;
        for (size_t i = 0; i < rows(); ++i) {
            if (column(by)[i] == name) result.push_back(std::stod(column(value)[i]));
        }
        return result;
    }
    [[nodiscard]] std::set<std::string> names_in(const std::string& by) const {
        return {column(by).begin(), column(by).end()};
    }
};

inline std::string reference_path(const std::string& name) {
    return std::string(PLACODE_SOURCE_DIR) + "/tests/data/statistics/" + name;
}

inline Table read_table(const std::string& name) {
    std::ifstream in(reference_path(name), std::ios::binary);
    if (!in) throw std::runtime_error("cannot open " + reference_path(name));
    std::ostringstream text;
    text << in.rdbuf();
    const auto rows = assessment::read_csv(text.str());
    Table table;
    table.header = rows.at(0).cells;
    table.columns.resize(table.header.size());
    for (size_t r = 1; r < rows.size(); ++r)
        for (size_t i = 0; i < rows[r].cells.size(); ++i)
            table.columns.at(i).push_back(rows[r].cells[i]);
    return table;
}

inline nlohmann::json expected(const std::string& name) {
    std::ifstream in(reference_path(name));
    if (!in) throw std::runtime_error("cannot open " + reference_path(name));
    return nlohmann::json::parse(in);
}

}  // namespace placode::tests

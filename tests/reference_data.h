// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads the small CSV and JSON references of tests/data.

#include <charconv>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "assessment/csv_reader.h"

namespace placode::testing_data {

inline std::string path(const std::string& name) {
    return PLACODE_SOURCE_DIR "/tests/data/" + name;
}

inline nlohmann::json json(const std::string& name) {
    std::ifstream in(path(name));
    if (!in) throw std::runtime_error("cannot open " + path(name));
    return nlohmann::json::parse(in);
}

/// Text cells by column name; quoted cells may hold commas.
inline std::map<std::string, std::vector<std::string>> table(const std::string& name) {
    std::ifstream in(path(name), std::ios::binary);
    if (!in) throw std::runtime_error("cannot open " + path(name));
    std::ostringstream text;
    text << in.rdbuf();
    const auto rows = assessment::read_csv(text.str());
    std::map<std::string, std::vector<std::string>> columns;
    for (size_t r = 1; r < rows.size(); ++r)
        for (size_t i = 0; i < rows[0].cells.size() && i < rows[r].cells.size(); ++i)
            columns[rows[0].cells[i]].push_back(rows[r].cells[i]);
    return columns;
}

inline double number(const std::string& text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc()) throw std::runtime_error("not a number: " + text);
    return value;
}

inline std::vector<double> column(const std::string& file, const std::string& name) {
    std::vector<double> values;
    const auto columns = table(file);
    for (const std::string& cell : columns.at(name)) values.push_back(number(cell));
    return values;
}

}  // namespace placode::testing_data

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
    std::ifstream in(path(name));
    if (!in) throw std::runtime_error("cannot open " + path(name));
    const auto cells_of = [](const std::string& line) {
        std::vector<std::string> cells(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"')
                quoted = !quoted;
            else if (c == ',' && !quoted)
                cells.emplace_back();
            else if (c != '\r')
                cells.back() += c;
        }
        return cells;
    };
    std::map<std::string, std::vector<std::string>> columns;
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> header = cells_of(line);
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = cells_of(line);
        for (size_t i = 0; i < header.size() && i < cells.size(); ++i)
            columns[header[i]].push_back(cells[i]);
    }
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

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers in messages and files: '.' in every locale (printf and std::to_string follow the user's).

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace placode::sim {

/// The shortest text that reads back as the same number; "nan" without a sign.
[[nodiscard]] inline std::string shortest_text(double value) {
    if (value != value) return "nan";
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} ? std::string(text.data(), end) : "-";
}

/// `digits` significant digits, at most 20, without zeros at the end.
[[nodiscard]] inline std::string rounded_text(double value, int digits) {
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                            std::chars_format::general, digits);
    return error == std::errc{} ? std::string(text.data(), end) : "-";
}

/// With `decimals` places; "-" for what is no finite number.
[[nodiscard]] inline std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) return "-";
    std::array<char, 400> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                            std::chars_format::fixed, decimals);
    return error == std::errc{} ? std::string(text.data(), end) : "-";
}

}  // namespace placode::sim

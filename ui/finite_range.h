// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an option takes that is a real number.

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

namespace placode::ui {

/// Accepts numbers from `low` to `high`, both included, and says so as CLI::Range does. CLI::Range
/// lets NaN pass, which is neither less than the one nor more than the other.
inline CLI::Validator finite_range(double low, double high) {
    std::ostringstream words;
    words << "FLOAT in [" << low << " - " << high << "]";
    return CLI::Validator(
        [low, high](std::string& text) {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high)
                return std::string();
            return "Value " + text + " not in range " + std::to_string(low) + " to " +
                   std::to_string(high);
        },
        words.str());
}

}  // namespace placode::ui

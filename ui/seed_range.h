// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an option takes that is a seed.

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

namespace placode::ui {

/// Accepts what uint64_t holds, in decimal digits, and says so as CLI::Range does. CLI11 by itself
/// takes -1 for the largest of all, 010 for 8, and what is too large for the largest.
inline CLI::Validator seed_range() {
    const std::string most = std::to_string(std::numeric_limits<uint64_t>::max());
    return CLI::Validator(
        [most](std::string& text) {
            uint64_t value = 0;
            const char* const last = text.data() + text.size();
            const auto read = std::from_chars(text.data(), last, value);
            if (read.ec != std::errc() || read.ptr != last)
                return "Value " + text + " not in range 0 to " + most;
            text = std::to_string(value);  // Without zeros before it, which would mean octal.
            return std::string();
        },
        "UINT in [0 - " + most + "]");
}

}  // namespace placode::ui

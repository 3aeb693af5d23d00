// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Seeds on the command line: "1-20,31".

#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/cli/cli.h"

namespace placode::cli {

/// In their order. Throws InputError naming `option` and the part that is wrong.
inline std::vector<uint64_t> seed_list(const std::string& option, const std::string& text) {
    constexpr uint64_t kMost = 10'000'000;
    std::vector<uint64_t> seeds;
    const auto refuse = [&](const std::string& part) {
        throw InputError(option + " " + text + ": found \"" + part +
                         "\"; expected seeds from 0 as in 1-20,31 (at most 10,000,000 of them)");
    };
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find(',', at), text.size());
        const std::string part = text.substr(at, end - at);
        const char* const last = part.data() + part.size();
        uint64_t low = 0;
        auto read = std::from_chars(part.data(), last, low);
        uint64_t high = low;
        if (read.ec == std::errc{} && read.ptr != last && *read.ptr == '-')
            read = std::from_chars(read.ptr + 1, last, high);
        if (read.ec != std::errc{} || read.ptr != last || high < low || high - low >= kMost ||
            seeds.size() + (high - low) >= kMost)
            refuse(part);
        for (uint64_t seed = low;; ++seed) {
            seeds.push_back(seed);
            if (seed == high) break;
        }
        at = end + 1;
    }
    return seeds;
}

}  // namespace placode::cli

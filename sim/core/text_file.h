// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files from outside, read whole: a link to /dev/zero must not fill the memory.

#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace placode::sim {

/// Definitions, tables of people, settings: our largest has 40 kB.
inline constexpr size_t kLargestText = size_t{64} << 20;
/// Tables of numbers: an hour at 1 kHz with twenty columns has some 600 MB.
inline constexpr size_t kLargestTable = size_t{1} << 30;

/// What is left in a stream [bytes]; nullopt where it is more than `most`. A device gives bytes
/// without end, and its size is not known before.
[[nodiscard]] inline std::optional<std::string> read_at_most(std::istream& in, size_t most) {
    std::string text;
    std::vector<char> part(size_t{1} << 16);
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0) {
        text.append(part.data(), static_cast<size_t>(in.gcount()));
        if (text.size() > most) return std::nullopt;
    }
    return text;
}

}  // namespace placode::sim

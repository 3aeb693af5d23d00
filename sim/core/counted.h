// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A count with its noun, in English: "1 file", "2 files". What the programs print and write into
// reports; the shell's own texts have Qt's plurals.

#include <concepts>
#include <string>
#include <string_view>

namespace placode::sim {

/// @param plural empty: the noun with an s.
template <std::integral Count>
[[nodiscard]] std::string counted(Count count, std::string_view noun,
                                  std::string_view plural = {}) {
    std::string text = std::to_string(count) + " ";
    if (count == 1) return text.append(noun);
    return plural.empty() ? text.append(noun).append("s") : text.append(plural);
}

}  // namespace placode::sim

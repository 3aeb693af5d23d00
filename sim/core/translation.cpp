// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/translation.h"

#include <algorithm>
#include <utility>

namespace placode::sim {
namespace {

const Translation* find_translation(std::string_view context, std::string_view english) noexcept {
    const auto key = [](const Translation& text) { return std::pair(text.context, text.english); };
    const auto all = embedded_translations();
    const auto found = std::ranges::lower_bound(all, std::pair(context, english), {}, key);
    return found != all.end() && key(*found) == std::pair(context, english) ? &*found : nullptr;
}

/// One for 1, one for 2 to 4 and 22 to 24, one for all others: as Qt chooses.
size_t polish_form(int64_t number) noexcept {
    const int64_t ones = number % 10, tens = number % 100;
    if (number == 1) return 0;
    return ones >= 2 && ones <= 4 && (tens < 12 || tens > 14) ? 1 : 2;
}

}  // namespace

std::string_view translated(std::string_view context, std::string_view english,
                            std::string_view language) noexcept {
    const Translation* text = language == "pl" ? find_translation(context, english) : nullptr;
    return text != nullptr ? text->polish[0] : english;
}

std::string_view translated(std::string_view context, std::string_view english,
                            std::string_view language, int64_t number) noexcept {
    const Translation* text = find_translation(context, english);
    if (text == nullptr) return english;
    return language == "pl" ? text->polish[polish_form(number)]
                            : text->counted[number == 1 ? 0 : 1];
}

}  // namespace placode::sim

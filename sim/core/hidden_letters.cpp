// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/hidden_letters.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace placode::sim {
namespace {

struct Range {
    char32_t first, last;
};
constexpr std::array<Range, 23> kHidden{
    {{0x0000, 0x001F},   {0x007F, 0x009F},   {0x00AD, 0x00AD},   {0x0600, 0x0605},
     {0x061C, 0x061C},   {0x06DD, 0x06DD},   {0x070F, 0x070F},   {0x0890, 0x0891},
     {0x08E2, 0x08E2},   {0x180E, 0x180E},   {0x200B, 0x200F},   {0x2028, 0x202E},
     {0x2060, 0x2064},   {0x2066, 0x206F},   {0xFEFF, 0xFEFF},   {0xFFF9, 0xFFFB},
     {0x110BD, 0x110BD}, {0x110CD, 0x110CD}, {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3},
     {0x1D173, 0x1D17A}, {0xE0001, 0xE0001}, {0xE0020, 0xE007F}}};

struct Letter {
    char32_t code = 0;
    size_t bytes = 1;
    bool damaged = true;
};

/// The first letter of a text that is not empty; of damaged bytes one at a time.
Letter first_letter(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
    const uint8_t head = byte(0);
    if (head < 0x80) return {head, 1, false};
    const size_t more = head >= 0xF0 ? 3 : head >= 0xE0 ? 2 : 1;
    if (head < 0xC2 || head > 0xF4 || more >= text.size()) return {};
    char32_t code = head & (0x3FU >> more);
    for (size_t i = 1; i <= more; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};
    if (code < kLeast[more] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
    return {code, more + 1, false};
}

bool is_shown(const Letter& letter, std::string_view but) {
    if (letter.damaged) return false;
    const bool allowed =
        letter.code < 0x80 && but.find(static_cast<char>(letter.code)) != std::string_view::npos;
    return allowed || !is_hidden_letter(letter.code);
}

}  // namespace

bool is_hidden_letter(char32_t code) noexcept {
    return std::any_of(kHidden.begin(), kHidden.end(), [code](const Range& range) {
        return code >= range.first && code <= range.last;
    });
}

bool has_hidden_letters(std::string_view text, std::string_view but) {
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (!is_shown(letter, but)) return true;
        text.remove_prefix(letter.bytes);
    }
    return false;
}

std::string without_hidden_letters(std::string_view text, std::string_view but) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (is_shown(letter, but))
            shown.append(text.substr(0, letter.bytes));
        else
            shown.append("\xEF\xBF\xBD");
        text.remove_prefix(letter.bytes);
    }
    return shown;
}

}  // namespace placode::sim

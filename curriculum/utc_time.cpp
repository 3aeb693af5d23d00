// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/utc_time.h"

#include <array>
#include <charconv>
#include <chrono>

namespace placode::curriculum {
namespace {

/// `count` digits at `at`, nothing when there are other characters.
std::optional<int> digits(const std::string& text, size_t at, size_t count) {
    if (at + count > text.size()) return std::nullopt;
    int value = 0;
    for (size_t i = at; i < at + count; ++i) {
        if (text[i] < '0' || text[i] > '9') return std::nullopt;
        value = value * 10 + (text[i] - '0');
    }
    return value;
}

std::optional<int64_t> day_of(const std::string& text) {
    const auto y = digits(text, 0, 4), m = digits(text, 5, 2), d = digits(text, 8, 2);
    if (!y || !m || !d || text[4] != '-' || text[7] != '-') return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*y),
                                           std::chrono::month(static_cast<unsigned>(*m)),
                                           std::chrono::day(static_cast<unsigned>(*d))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days(date).time_since_epoch().count();
}

std::string padded(unsigned value, size_t width) {
    std::string text = std::to_string(value);
    return std::string(width > text.size() ? width - text.size() : 0, '0') + text;
}

}  // namespace

std::optional<int64_t> utc_seconds(const std::string& text) {
    const auto day = day_of(text);
    if (!day) return std::nullopt;
    const int64_t midnight = *day * 86400;
    if (text.size() == 10) return midnight;
    const auto h = digits(text, 11, 2), m = digits(text, 14, 2), s = digits(text, 17, 2);
    if (!h || !m || !s || text[10] != 'T' || text[13] != ':' || text[16] != ':' ||
        text.back() != 'Z' || *h > 23 || *m > 59 || *s > 60)
        return std::nullopt;
    if (text.size() > 20) {  // ".123Z"
        if (text[19] != '.' || text.size() < 22) return std::nullopt;
        if (!digits(text, 20, text.size() - 21)) return std::nullopt;
    } else if (text.size() != 20) {
        return std::nullopt;
    }
    return midnight + *h * 3600 + *m * 60 + *s;
}

std::string utc_day(int64_t seconds) {
    // Floor, so that times before 1970 have the right day too.
    const int64_t days = (seconds - ((seconds % 86400) + 86400) % 86400) / 86400;
    const std::chrono::year_month_day date{
        std::chrono::sys_days(std::chrono::days(static_cast<int>(days)))};
    return padded(static_cast<unsigned>(static_cast<int>(date.year())), 4) + "-" +
           padded(static_cast<unsigned>(date.month()), 2) + "-" +
           padded(static_cast<unsigned>(date.day()), 2);
}

std::string utc_text(int64_t seconds) {
    const auto of_day = static_cast<unsigned>(((seconds % 86400) + 86400) % 86400);
    return utc_day(seconds) + "T" + padded(of_day / 3600, 2) + ":" + padded(of_day / 60 % 60, 2) +
           ":" + padded(of_day % 60, 2) + "Z";
}

}  // namespace placode::curriculum

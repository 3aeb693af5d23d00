// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/reason.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "assessment/metrics.h"

namespace placode::assessment {
namespace {

void replace_all(std::string& text, std::string_view what, const std::string& with) {
    for (size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

std::string english_between(const BetweenBites& between) {
    std::string text = between_pattern(between);
    const auto [first, second] = between_numbers(between);
    replace_all(text, "%1", std::to_string(first));
    replace_all(text, "%2", std::to_string(second));
    return text;
}

std::string times(int count) {
    if (count == 1) return "once";
    if (count == 2) return "twice";
    return std::to_string(count) + " times";
}

}  // namespace

std::string fill_places(std::string pattern, const ReasonWords& words) {
    replace_all(pattern, "{value}", words.value);
    replace_all(pattern, "{unit}", words.unit);
    replace_all(pattern, "{points}", words.points);
    replace_all(pattern, "{count}", words.count);
    replace_all(pattern, "{times}", words.times);
    replace_all(pattern, " {where}", words.where);
    replace_all(pattern, "{where}", words.where);
    replace_all(pattern, "{metric}", words.metric);
    return pattern;
}

const char* between_pattern(const BetweenBites& between) noexcept {
    if (!between.any()) return "";
    if (between.before == 0)
        return between.upright ? " between the upper end and bite %1"
                               : " between the left end and bite %1";
    if (between.after == 0)
        return between.upright ? " between bite %1 and the lower end"
                               : " between bite %1 and the right end";
    return " between bites %1 and %2";
}

std::pair<int, int> between_numbers(const BetweenBites& between) noexcept {
    const auto [low, high] = std::minmax(between.before, between.after);
    return low == 0 ? std::pair(high, 0) : std::pair(low, high);
}

std::string reason_number(double value) {
    const double size = std::abs(value);
    const int decimals = size >= 100 || value == std::floor(value) ? 0 : size >= 1 ? 1 : 2;
    char text[64];
    const auto done =
        size < 1e6
            ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals)
            : std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4);
    return done.ec == std::errc() ? std::string(text, done.ptr) : "?";
}

ReasonWords english_places(const ReasonMeaning& meaning, double points) {
    const MetricDefinition* metric = metric_definition(meaning.metric);
    ReasonWords words;
    words.value = reason_number(meaning.value);
    words.unit = metric != nullptr ? std::string(metric->unit) : "";
    words.points = reason_number(points);
    words.count = std::to_string(meaning.count);
    words.times = times(meaning.count);
    if (meaning.hour > 0) words.where = " at " + std::to_string(meaning.hour) + " o'clock";
    if (meaning.between.any()) words.where = english_between(meaning.between);
    words.metric = metric != nullptr ? std::string(metric->name) : meaning.metric;
    return words;
}

std::string english_words(const ReasonMeaning& meaning, double points) {
    return fill_places(meaning.pattern, english_places(meaning, points));
}

}  // namespace placode::assessment

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reason_json.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <system_error>

#include "db/store.h"

namespace placode::db {
namespace {

std::string exact(double value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

double number(const std::string& text) {
    double value = 0;
    const auto done = std::from_chars(text.data(), text.data() + text.size(), value);
    if (done.ec != std::errc() || done.ptr != text.data() + text.size())
        throw StoreError(StoreError::Kind::kDamaged, "reason: \"" + text + "\" is no number");
    return value;
}

}  // namespace

std::string reason_json(const assessment::ReasonMeaning& meaning) {
    if (meaning.pattern.empty()) return {};
    nlohmann::ordered_json json;
    json["pattern"]["en"] = meaning.pattern;
    if (!meaning.pattern_pl.empty()) json["pattern"]["pl"] = meaning.pattern_pl;
    json["metric"] = meaning.metric;
    json["value"] = exact(meaning.value);
    json["count"] = meaning.count;
    json["hour"] = meaning.hour;
    return json.dump();
}

assessment::ReasonMeaning reason_from_json(const std::string& text) {
    assessment::ReasonMeaning meaning;
    if (text.empty()) return meaning;
    try {
        const auto json = nlohmann::json::parse(text);
        meaning.pattern = json.at("pattern").at("en");
        meaning.pattern_pl = json.at("pattern").value("pl", "");
        meaning.metric = json.at("metric");
        meaning.value = number(json.at("value"));
        meaning.count = json.at("count");
        meaning.hour = json.at("hour");
    } catch (const nlohmann::json::exception& error) {
        throw StoreError(StoreError::Kind::kDamaged,
                         std::string("reason: what it means is damaged: ") + error.what());
    }
    return meaning;
}

}  // namespace placode::db

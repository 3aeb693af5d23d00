// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/draft_text.h"

#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

namespace placode::curriculum {
namespace {

using Json = nlohmann::ordered_json;  // "first" is the first in the file

bool is_letter(unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }

/// As a word of its own: "REDRAFTED" says nothing.
bool holds_word(const std::string& text, std::string_view word) {
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const size_t end = at + word.size();
        const bool begins = at == 0 || !is_letter(static_cast<unsigned char>(text[at - 1]));
        const bool ends = end == text.size() || !is_letter(static_cast<unsigned char>(text[end]));
        if (begins && ends) return true;
    }
    return false;
}

bool is_draft(const std::string& text) {
    return holds_word(text, "DRAFT") || holds_word(text, "WERSJA ROBOCZA");
}

std::optional<LocalText> find_draft(const Json& value) {
    if (value.is_string()) {
        const auto text = value.get<std::string>();
        return is_draft(text) ? std::optional(LocalText{text, {}}) : std::nullopt;
    }
    if (value.is_object() && value.contains("en") && value["en"].is_string()) {
        const bool both = value.contains("pl") && value["pl"].is_string();
        LocalText text{value["en"].get<std::string>(),
                       both ? value["pl"].get<std::string>() : std::string()};
        return is_draft(text.en) || is_draft(text.pl) ? std::optional(text) : std::nullopt;
    }
    for (const Json& each : value.is_structured() ? value : Json::array())
        if (auto found = find_draft(each)) return found;
    return std::nullopt;
}

}  // namespace

std::optional<LocalText> draft_text(const std::string& json) {
    const Json read = Json::parse(json, nullptr, false);
    return read.is_discarded() ? std::nullopt : find_draft(read);
}

}  // namespace placode::curriculum

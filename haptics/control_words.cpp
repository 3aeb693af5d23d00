// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/control_words.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace placode::haptics {

namespace {

using sim::Key;
using Replacement = std::pair<std::string, std::string>;

/// In both languages, as the sentences have them.
constexpr std::pair<std::string_view, std::string_view> kButtons[] = {
    {"left button", "right button"}, {"lewy przycisk", "prawy przycisk"}};
constexpr std::pair<std::string_view, std::string_view> kSticks[] = {
    {"left stick", "right stick"},
    {"Left stick", "Right stick"},
    {"lewa ga\xC5\x82ka", "prawa ga\xC5\x82ka"},
    {"Lewa ga\xC5\x82ka", "Prawa ga\xC5\x82ka"},
    {"lew\xC4\x85 ga\xC5\x82k\xC4\x85", "praw\xC4\x85 ga\xC5\x82k\xC4\x85"},
    {"Lew\xC4\x85 ga\xC5\x82k\xC4\x85", "Praw\xC4\x85 ga\xC5\x82k\xC4\x85"}};

/// Part of a word: a letter, a digit, or any byte of a letter that is not of the English alphabet.
constexpr bool in_word(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80;
}

void add_exchanged(std::vector<Replacement>& out,
                   std::span<const std::pair<std::string_view, std::string_view>> pairs) {
    for (const auto& [one, other] : pairs) {
        out.emplace_back(one, other);
        out.emplace_back(other, one);
    }
}

/// Four keys that are said as one thing.
void name_arrows(std::vector<Replacement>& out, const ControlLayout& layout,
                 std::string_view language) {
    std::string names;
    bool same = true;
    for (const Key does : {Key::kUp, Key::kLeft, Key::kDown, Key::kRight}) {
        same = same && layout.key_for(does) == does;
        names += (names.empty() ? "" : " ") + key_name_in(layout.key_for(does), language);
    }
    if (same) return;
    for (const char* words : {"arrow keys", "Arrow keys", "arrows",
                              "klawisze strza\xC5\x82"
                              "ek",
                              "Klawisze strza\xC5\x82"
                              "ek",
                              "strza\xC5\x82ki"})
        out.emplace_back(words, names);
}

/// What is said otherwise than as delivered.
std::vector<Replacement> replacements(const ControlLayout& layout, HintDevice device,
                                      std::string_view language) {
    std::vector<Replacement> out;
    const auto add = [&](Key does) {
        if (layout.key_for(does) != does)
            out.emplace_back(key_name_in(does, language),
                             key_name_in(layout.key_for(does), language));
    };
    if (device == HintDevice::kMouse && layout.buttons_exchanged) add_exchanged(out, kButtons);
    if (device == HintDevice::kGamepad && layout.sticks_exchanged) add_exchanged(out, kSticks);
    if (device == HintDevice::kKeyboard) name_arrows(out, layout, language);
    for (const Control& control : layout_controls())
        if (is_key_with(device, control.does)) add(control.does);
    return out;
}

}  // namespace

bool is_key_with(HintDevice device, Key does) noexcept {
    if (device == HintDevice::kMouse || device == HintDevice::kKeyboard) return true;
    return does == Key::kTab || does == Key::kSpace || does == Key::kL || does == Key::kM;
}

std::string key_name_in(Key key, std::string_view language) {
    if (key == Key::kSpace && language == "pl") return "Spacja";
    return std::string(key_name(key));
}

std::string in_layout(std::string_view text, const ControlLayout& layout, HintDevice device,
                      std::string_view language) {
    const std::vector<Replacement> words = replacements(layout, device, language);
    std::string out;
    for (size_t i = 0; i < text.size();) {
        const bool begins = i == 0 || !in_word(text[i - 1]) || !in_word(text[i]);
        const auto found = std::ranges::find_if(words, [&](const Replacement& word) {
            const size_t end = i + word.first.size();
            return begins && text.substr(i, word.first.size()) == word.first &&
                   (end == text.size() || !in_word(text[end]) || !in_word(word.first.back()));
        });
        if (found == words.end()) {
            out += text[i++];
            continue;
        }
        out += found->second;
        i += found->first.size();
    }
    return out;
}

}  // namespace placode::haptics

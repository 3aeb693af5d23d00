// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/control_words.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/core/translation.h"

namespace placode::haptics {

namespace {

using sim::Key;
using Replacement = std::pair<std::string, std::string>;

/// As the sentences have them, in the English of the translation file: in Polish "with the left
/// stick" is another form of the same words.
constexpr std::pair<std::string_view, std::string_view> kButtons[] = {
    {"left button", "right button"}};
constexpr std::pair<std::string_view, std::string_view> kSticks[] = {
    {"left stick", "right stick"},
    {"Left stick", "Right stick"},
    {"with the left stick", "with the right stick"},
    {"With the left stick", "With the right stick"}};

std::string said_in(std::string_view language, std::string_view english) {
    return std::string(sim::translated("Attempt", english, language));
}

/// Part of a word: a letter, a digit, or any byte of a letter that is not of the English alphabet.
constexpr bool in_word(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80;
}

void add_exchanged(std::vector<Replacement>& out,
                   std::span<const std::pair<std::string_view, std::string_view>> pairs,
                   std::string_view language) {
    for (const auto& [one, other] : pairs) {
        out.emplace_back(said_in(language, one), said_in(language, other));
        out.emplace_back(said_in(language, other), said_in(language, one));
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
    for (const char* words : {"arrow keys", "Arrow keys", "arrows"})
        out.emplace_back(said_in(language, words), names);
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
    if (device == HintDevice::kMouse && layout.buttons_exchanged)
        add_exchanged(out, kButtons, language);
    if (device == HintDevice::kGamepad && layout.sticks_exchanged)
        add_exchanged(out, kSticks, language);
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
    return std::string(sim::translated("Key", key_name(key), language));
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

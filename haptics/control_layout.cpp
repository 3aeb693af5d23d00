// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/control_layout.h"

#include <algorithm>
#include <utility>

namespace placode::haptics {

namespace {

using sim::Key;

constexpr Control kControls[] = {
    {Key::kW, "up", "Move up"},
    {Key::kS, "down", "Move down"},
    {Key::kA, "left", "Move left"},
    {Key::kD, "right", "Move right"},
    {Key::kF, "deeper", "Go deeper"},
    {Key::kR, "back", "Come back"},
    {Key::kQ, "turn-left", "Turn to the left"},
    {Key::kE, "turn-right", "Turn to the right"},
    {Key::kX, "cut", "Cut, close the jaws"},
    {Key::kC, "coagulate", "Coagulate"},
    {Key::kControl, "precise", "Precise"},
    {Key::kShift, "turn", "Mouse turns, wheel goes further"},
    {Key::kSpace, "still", "Hold the instrument still"},
    {Key::kTab, "next", "Next instrument"},
    {Key::kUp, "scope-up", "Scope up"},
    {Key::kDown, "scope-down", "Scope down"},
    {Key::kLeft, "scope-left", "Scope left"},
    {Key::kRight, "scope-right", "Scope right"},
    {Key::kL, "wipe", "Wipe the lens"},
    {Key::kM, "sound", "Sound off, on"},
};

struct NamedKey {
    Key key;
    std::string_view word;
    std::string_view sign;  ///< On the screen; "" = the word.
};
constexpr NamedKey kNames[] = {
    {Key::kW, "W", ""},
    {Key::kA, "A", ""},
    {Key::kS, "S", ""},
    {Key::kD, "D", ""},
    {Key::kQ, "Q", ""},
    {Key::kE, "E", ""},
    {Key::kR, "R", ""},
    {Key::kF, "F", ""},
    {Key::kX, "X", ""},
    {Key::kC, "C", ""},
    {Key::kV, "V", ""},
    {Key::kB, "B", ""},
    {Key::kG, "G", ""},
    {Key::kH, "H", ""},
    {Key::kI, "I", ""},
    {Key::kJ, "J", ""},
    {Key::kK, "K", ""},
    {Key::kL, "L", ""},
    {Key::kM, "M", ""},
    {Key::kN, "N", ""},
    {Key::kO, "O", ""},
    {Key::kP, "P", ""},
    {Key::kT, "T", ""},
    {Key::kU, "U", ""},
    {Key::kY, "Y", ""},
    {Key::kZ, "Z", ""},
    {Key::k0, "0", ""},
    {Key::k3, "3", ""},
    {Key::k4, "4", ""},
    {Key::k5, "5", ""},
    {Key::k6, "6", ""},
    {Key::k7, "7", ""},
    {Key::k8, "8", ""},
    {Key::k9, "9", ""},
    {Key::kComma, ",", ""},
    {Key::kPeriod, ".", ""},
    {Key::kSlash, "/", ""},
    {Key::kSemicolon, ";", ""},
    {Key::kApostrophe, "'", ""},
    {Key::kLeftBracket, "[", ""},
    {Key::kRightBracket, "]", ""},
    {Key::kBackslash, "\\", ""},
    {Key::kGrave, "`", ""},
    {Key::kSpace, "Space", ""},
    {Key::kTab, "Tab", ""},
    {Key::kShift, "Shift", ""},
    {Key::kControl, "Ctrl", ""},
    {Key::kAlt, "Alt", ""},
    {Key::kBackspace, "Backspace", ""},
    {Key::kInsert, "Insert", ""},
    {Key::kDelete, "Delete", ""},
    {Key::kHome, "Home", ""},
    {Key::kEnd, "End", ""},
    {Key::kPageUp, "PageUp", ""},
    {Key::kPageDown, "PageDown", ""},
    {Key::kLeft, "Left", "\xE2\x86\x90"},
    {Key::kRight, "Right", "\xE2\x86\x92"},
    {Key::kUp, "Up", "\xE2\x86\x91"},
    {Key::kDown, "Down", "\xE2\x86\x93"},
    {Key::kPad0, "Num0", ""},
    {Key::kPad1, "Num1", ""},
    {Key::kPad2, "Num2", ""},
    {Key::kPad3, "Num3", ""},
    {Key::kPad4, "Num4", ""},
    {Key::kPad5, "Num5", ""},
    {Key::kPad6, "Num6", ""},
    {Key::kPad7, "Num7", ""},
    {Key::kPad8, "Num8", ""},
    {Key::kPad9, "Num9", ""},
};

// The right hand lies on J K L as the left one does on A S D; the thumb keeps the space bar.
constexpr std::pair<Key, Key> kLeftHanded[] = {
    {Key::kW, Key::kI},           {Key::kA, Key::kJ}, {Key::kS, Key::kK}, {Key::kD, Key::kL},
    {Key::kQ, Key::kU},           {Key::kE, Key::kO}, {Key::kR, Key::kY}, {Key::kF, Key::kH},
    {Key::kX, Key::kN},           {Key::kC, Key::kM}, {Key::kL, Key::kB}, {Key::kM, Key::kV},
    {Key::kTab, Key::kBackspace},
};

constexpr size_t at(Key key) noexcept { return static_cast<size_t>(key); }

const Control* control_named(std::string_view name) noexcept {
    const auto* found = std::ranges::find(kControls, name, &Control::name);
    return found != std::end(kControls) ? found : nullptr;
}

bool is_control(Key does) noexcept {
    return std::ranges::find(kControls, does, &Control::does) != std::end(kControls);
}

std::string all_control_names() {
    std::string out;
    for (const Control& control : kControls) out.append(control.name).append(", ");
    return out + "buttons, sticks";
}

bool read_exchange(std::string_view word, std::string_view value) {
    if (value == "exchanged") return true;
    if (value == "usual") return false;
    throw LayoutError("layout of controls: " + std::string(word) + "=" + std::string(value) +
                      ": exchanged or usual");
}

/// One "name=value" of a layout's text, into the keys that are wanted.
void read_word(std::string_view word, std::array<Key, std::size(kControls)>& keys,
               ControlLayout& out) {
    const size_t sign = word.find('=');
    const std::string_view name = word.substr(0, sign);
    const std::string_view value = sign == word.npos ? std::string_view() : word.substr(sign + 1);
    if (name == "buttons") {
        out.buttons_exchanged = read_exchange(name, value);
        return;
    }
    if (name == "sticks") {
        out.sticks_exchanged = read_exchange(name, value);
        return;
    }
    const Control* control = control_named(name);
    if (control == nullptr || sign == word.npos)
        throw LayoutError("layout of controls: \"" + std::string(word) +
                          "\" is none of left-handed, or NAME=KEY with a name of " +
                          all_control_names());
    const std::optional<Key> key = key_of_word(value);
    if (!key)
        throw LayoutError("layout of controls: " + std::string(name) + "=" + std::string(value) +
                          ": there is no such key to choose; e.g. " + std::string(name) + "=V");
    keys[static_cast<size_t>(control - kControls)] = *key;
}

}  // namespace

std::span<const Control> layout_controls() noexcept { return kControls; }

std::string_view key_name(Key key) noexcept {
    const auto* found = std::ranges::find(kNames, key, &NamedKey::key);
    if (found == std::end(kNames)) return {};
    return found->sign.empty() ? found->word : found->sign;
}

std::string_view key_word(Key key) noexcept {
    const auto* found = std::ranges::find(kNames, key, &NamedKey::key);
    return found != std::end(kNames) ? found->word : std::string_view();
}

std::optional<Key> key_of_word(std::string_view word) noexcept {
    const auto* found = std::ranges::find(kNames, word, &NamedKey::word);
    if (found == std::end(kNames)) return std::nullopt;
    return found->key;
}

ControlLayout::ControlLayout() {
    for (size_t i = 0; i < does_.size(); ++i) {
        const auto key = static_cast<Key>(i);
        does_[i] = key_word(key).empty() || is_control(key) ? key : Key::kCount;
    }
}

ControlLayout ControlLayout::left_handed() {
    ControlLayout out;
    for (const auto& [does, key] : kLeftHanded) out.does_[at(does)] = Key::kCount;
    for (const auto& [does, key] : kLeftHanded) out.does_[at(key)] = does;
    out.buttons_exchanged = true;
    return out;
}

ControlLayout ControlLayout::parse(std::string_view text) {
    ControlLayout out;
    std::array<Key, std::size(kControls)> keys{};
    const auto begin_from = [&](const ControlLayout& base) {
        out = base;
        for (size_t i = 0; i < keys.size(); ++i) keys[i] = base.key_for(kControls[i].does);
    };
    begin_from({});
    bool first = true;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (word.empty()) continue;
        if (first && word == "left-handed")
            begin_from(left_handed());
        else
            read_word(word, keys, out);
        first = false;
    }
    for (const Control& control : kControls) out.does_[at(out.key_for(control.does))] = Key::kCount;
    for (size_t i = 0; i < keys.size(); ++i) {
        Key& does = out.does_[at(keys[i])];
        if (does != Key::kCount) {
            const auto* other = std::ranges::find(kControls, does, &Control::does);
            throw LayoutError("layout of controls: " + std::string(other->name) + " and " +
                              std::string(kControls[i].name) + " are both on the key " +
                              std::string(key_word(keys[i])) + "; give one of them another");
        }
        does = kControls[i].does;
    }
    return out;
}

std::string ControlLayout::text() const {
    if (*this == ControlLayout()) return {};
    const ControlLayout left = left_handed();
    std::string out;
    const auto add = [&out](std::string_view name, std::string_view value) {
        if (!out.empty()) out += ' ';
        out.append(name).append("=").append(value);
    };
    // From whichever fewer things differ.
    const auto differing = [this](const ControlLayout& base) {
        return std::ranges::count_if(kControls, [&](const Control& control) {
            return key_for(control.does) != base.key_for(control.does);
        });
    };
    const ControlLayout base = differing(left) < differing({}) ? left : ControlLayout();
    if (base == left) out = "left-handed";
    for (const Control& control : kControls)
        if (key_for(control.does) != base.key_for(control.does))
            add(control.name, key_word(key_for(control.does)));
    if (buttons_exchanged != base.buttons_exchanged)
        add("buttons", buttons_exchanged ? "exchanged" : "usual");
    if (sticks_exchanged != base.sticks_exchanged)
        add("sticks", sticks_exchanged ? "exchanged" : "usual");
    return out;
}

Key ControlLayout::does(Key key) const noexcept {
    return at(key) < does_.size() ? does_[at(key)] : Key::kCount;
}

Key ControlLayout::key_for(Key does) const noexcept {
    const auto* found = std::ranges::find(does_, does);
    return static_cast<Key>(found - does_.begin());
}

bool ControlLayout::put(Key does, Key key) noexcept {
    if (!is_control(does) || key_word(key).empty()) return false;
    const Key before = key_for(does);
    std::swap(does_[at(before)], does_[at(key)]);
    return true;
}

bool is_down(const sim::WindowInput& window, const ControlLayout& layout, Key does) noexcept {
    const Key key = layout.key_for(does);
    return key != Key::kCount && window.is_down(key);
}

}  // namespace placode::haptics

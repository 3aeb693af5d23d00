// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which key of the window does what for the hands: as delivered, for the left hand on the mouse, or
// as a person chose. Enter, Escape and the function keys are nobody's to choose: they end, pause
// and explain an attempt. Pure: the window reports keys, devices are given what they do.

#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "haptics/window_input.h"

namespace placode::haptics {

/// Bad text of a layout; the message names the word and the way out.
class LayoutError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Something that a key does, named after the key that does it as delivered.
struct Control {
    sim::Key does = sim::Key::kCount;
    std::string_view name;    ///< In a layout's text, e.g. "cut".
    std::string_view action;  ///< English; translated in ui.
};
/// All that can be put on another key, in the order in which a person would look for it.
[[nodiscard]] std::span<const Control> layout_controls() noexcept;

/// As printed on the key: "W", "Space", an arrow. Empty for keys that are nobody's to choose.
[[nodiscard]] std::string_view key_name(sim::Key key) noexcept;
/// In a layout's text: the same but for the arrows, e.g. "Up".
[[nodiscard]] std::string_view key_word(sim::Key key) noexcept;
/// The key that has this word; nothing where none has it.
[[nodiscard]] std::optional<sim::Key> key_of_word(std::string_view word) noexcept;

/// Value type; compares by content.
class ControlLayout {
 public:
    /// As delivered: W A S D beside a mouse in the right hand.
    ControlLayout();
    /// The mouse in the left hand: its buttons exchanged, the keys in the mirror image.
    [[nodiscard]] static ControlLayout left_handed();
    /// Words with spaces between: "left-handed" first, where it begins from there; then "cut=V",
    /// "buttons=exchanged", "sticks=exchanged" (or "=usual"). Empty: as delivered. Throws
    /// LayoutError for unknown words, and for two things on one key.
    [[nodiscard]] static ControlLayout parse(std::string_view text);
    /// What parse() reads back.
    [[nodiscard]] std::string text() const;

    /// What a key does; Key::kCount: nothing.
    [[nodiscard]] sim::Key does(sim::Key key) const noexcept;
    /// The key that does it.
    [[nodiscard]] sim::Key key_for(sim::Key does) const noexcept;
    /// Puts it on `key`; what that key did until now goes to the key that is left. False, and
    /// nothing happens, where the key is nobody's to choose or `does` is no control.
    bool put(sim::Key does, sim::Key key) noexcept;

    bool buttons_exchanged = false;  ///< The right button of the mouse cuts, the left coagulates.
    bool sticks_exchanged = false;   ///< The right stick of a gamepad moves, the left one turns.

    bool operator==(const ControlLayout&) const = default;

 private:
    std::array<sim::Key, static_cast<size_t>(sim::Key::kCount)> does_{};
};

/// The key that does it is held.
[[nodiscard]] bool is_down(const sim::WindowInput& window, const ControlLayout& layout,
                           sim::Key does) noexcept;

}  // namespace placode::haptics

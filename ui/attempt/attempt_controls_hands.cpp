// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the instruments see of keys, buttons and pointer while operating, and what goes to nobody.
#include <utility>

#include "ui/attempt/attempt_controls.h"

namespace placode::ui {

namespace {

using sim::Key;

constexpr uint16_t kPadPrecise = 1U << 4, kPadStart = 1U << 7;

constexpr size_t place_of(Key key) { return static_cast<size_t>(key); }

}  // namespace

void AttemptControls::hand_key(Key key, char32_t types) {
    const Key does = setup_.layout.does(key);
    if (does == Key::kCount) return;
    // Where nothing was chosen it is the letter that counts, below; the place where the keyboard
    // has no Latin letters.
    if (does == Key::kL || does == Key::kM) {
        if (key != does || types != 0)
            commands_.push_back(does == Key::kL ? Command::kWipeLens : Command::kMute);
        return;
    }
    held_.set(place_of(does));
    tapped_.set(place_of(does));
    ++devices_.presses[place_of(does)];
}

/// Letters that mean something wherever the keyboard puts them, unless their key does something
/// else: sound and lens. A key that is held types on and on; L and M mean it once.
void AttemptControls::letter(char32_t code) {
    if (code == U'+') commands_.push_back(Command::kLouder);
    if (code == U'-') commands_.push_back(Command::kSofter);
    const bool mute = code == U'm' || code == U'M';
    if (!mute && code != U'l' && code != U'L') return;
    const Key usual = mute ? Key::kM : Key::kL;
    if (!std::exchange(struck_, false) || setup_.layout.does(usual) != usual) return;
    commands_.push_back(mute ? Command::kMute : Command::kWipeLens);
}

/// What is held stays held for nobody: after a menu everything has to be pressed anew.
void AttemptControls::hands_off() {
    held_.reset();
    tapped_.reset();
    buttons_.reset();
    clicked_.reset();
}

void AttemptControls::publish(const sim::WindowInput& totals, bool operating) {
    const double wheel = totals.wheel - last_totals_.wheel;
    const double x = totals.mouse_x - last_totals_.mouse_x;
    const double y = totals.mouse_y - last_totals_.mouse_y;
    last_totals_ = totals;
    if (operating) {
        devices_.wheel += wheel;
        devices_.mouse_x += x;
        devices_.mouse_y += y;
    } else {
        hands_off();
    }
    // What was pressed and let go between two pictures is seen for one of them.
    devices_.down = held_ | tapped_;
    for (const Key key : {Key::kShift, Key::kControl})
        devices_.down.set(place_of(key), operating && haptics::is_down(totals, setup_.layout, key));
    const size_t first = setup_.layout.buttons_exchanged ? 1 : 0;
    devices_.left = buttons_[first] || clicked_[first];
    devices_.right = buttons_[1 - first] || clicked_[1 - first];
    devices_.middle = buttons_[2] || clicked_[2];
    tapped_.reset();
    clicked_.reset();
    devices_.focused = totals.focused;
    devices_.gamepad = totals.gamepad;
    devices_.gamepad_axis = totals.gamepad_axis;
    if (setup_.layout.sticks_exchanged)
        for (const size_t axis : {0, 1})
            std::swap(devices_.gamepad_axis[axis], devices_.gamepad_axis[axis + 2]);
    // A pad's buttons are states: one that left a screen, or is held through it, is spent until it
    // is let go. Precision fires nothing, and a hand that lost it would run: it goes on.
    if (operating)
        spent_pad_ &= totals.gamepad_buttons;
    else
        spent_pad_ = totals.gamepad_buttons & static_cast<uint16_t>(~kPadPrecise);
    devices_.gamepad_buttons =
        totals.gamepad_buttons & static_cast<uint16_t>(~(spent_pad_ | kPadStart));
    if (!operating) {
        // Triggers rest at -1.
        devices_.gamepad_axis = {0, 0, 0, 0, -1, -1};
        devices_.gamepad_buttons = 0;
    }
    devices_.t_ns = totals.t_ns;
}

}  // namespace placode::ui

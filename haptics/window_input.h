// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What window, mouse, keyboard and gamepad have seen: totals that only grow, so that a reader who
// misses an update loses nothing. Published by the main thread, read by the devices. No GLFW types.

#include <array>
#include <bitset>
#include <cstdint>

namespace placode::sim {

/// Keys of the window, named after what is printed on an English keyboard in that place. For the
/// devices a name stands for what the key does as delivered: control_layout.h puts another there.
enum class Key : uint8_t {
    // clang-format off
    kW, kA, kS, kD, kQ, kE, kR, kF, kX, kC, kV, kB, kSpace, kTab, kShift, kControl, kEnter, kEscape,
    kLeft, kRight, kUp, kDown, kF1, kF2, kF3, kF5, kF12,
    kCut, kCoag,  ///< Pedals that appear as a keyboard (F13, F14); 1 and 2 stand in for them.
    kG, kH, kI, kJ, kK, kL, kM, kN, kO, kP, kT, kU, kY, kZ,
    k0, k3, k4, k5, k6, k7, k8, k9,
    kComma, kPeriod, kSlash, kSemicolon, kApostrophe, kLeftBracket, kRightBracket, kBackslash,
    kGrave, kAlt, kBackspace, kInsert, kDelete, kHome, kEnd, kPageUp, kPageDown,
    kPad0, kPad1, kPad2, kPad3, kPad4, kPad5, kPad6, kPad7, kPad8, kPad9,
    kCount
    // clang-format on
};

struct WindowInput {
    double mouse_x = 0, mouse_y = 0;  ///< Accumulated motion [counts], y down.
    double wheel = 0;                 ///< Accumulated notches, + = away from the user.
    std::bitset<static_cast<size_t>(Key::kCount)> down;                ///< Held now.
    std::array<uint32_t, static_cast<size_t>(Key::kCount)> presses{};  ///< Times pressed so far.
    bool left = false, right = false, middle = false;
    bool focused = true;  ///< false: pedals and motion must stop.
    bool gamepad = false;
    std::array<float, 6> gamepad_axis{};  ///< GLFW order.
    uint16_t gamepad_buttons = 0;
    int64_t t_ns = 0;  ///< CLOCK_MONOTONIC of this state.

    [[nodiscard]] bool is_down(Key key) const { return down[static_cast<size_t>(key)]; }
};

}  // namespace placode::sim

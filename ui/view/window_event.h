// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happened at the window, in order; window_input.h says what is held and how far things went.

#include <cstdint>
#include <vector>

#include "haptics/window_input.h"

namespace placode::view {

/// One thing that happened at the window. Between two pictures several may happen: their order says
/// which screen each of them was meant for.
struct WindowEvent {
    enum class Kind : uint8_t {
        kKey,     ///< `key` went down or up; `letter` is what it types if that is no ASCII, else 0.
        kButton,  ///< Mouse button `button` (0 left, 1 right, 2 middle) went down or up.
        kLetter,  ///< `letter` was typed; 8 = backspace.
        kStart,   ///< The gamepad's Start button went down.
        kFocus,   ///< The window got the focus (down) or lost it.
        kHidden,  ///< The window was minimised.
        kClose    ///< Somebody wants to close the window.
    };
    Kind kind = Kind::kKey;
    sim::Key key = sim::Key::kCount;
    uint8_t button = 0;
    bool down = false;
    bool unseen = false;  ///< A key is up, but nobody saw when: it was not let go to answer.
    char32_t letter = 0;
};
using WindowEvents = std::vector<WindowEvent>;

}  // namespace placode::view

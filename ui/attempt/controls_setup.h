// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an attempt's controls are told before it begins: from its task, its mode and its device.

#include <string_view>

#include "curriculum/task.h"
#include "ui/attempt/arguments.h"
#include "ui/attempt/attempt_controls.h"

namespace placode::ui {

/// What moves the hand is pressed in the window itself: mouse, keyboard, gamepad.
[[nodiscard]] bool is_in_window(std::string_view device);
/// The hand stands still without the window's focus, and Tab leads from hand to hand: the same, and
/// a SpaceMouse.
[[nodiscard]] bool has_window_hands(std::string_view device);

[[nodiscard]] ControlsSetup controls_setup(const curriculum::Task& task,
                                           const Arguments& arguments);

}  // namespace placode::ui

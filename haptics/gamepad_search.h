// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Is a gamepad plugged in? Asked of the kernel's list of input devices, which everybody may read,
// so that a pad that is there but may not be opened is told apart from none.

#include <string>
#include <vector>

namespace placode::haptics {

/// Where the kernel shows its input devices; tests make their own.
struct InputFolders {
    std::string list = "/sys/class/input";  ///< What each device is.
    std::string devices = "/dev/input";     ///< The device files.
};

struct GamepadSearch {
    std::vector<std::string> found;       ///< Names of pads that can be used.
    std::vector<std::string> unreadable;  ///< Device files of pads that this account may not read.
    int looked_at = 0;                    ///< Input devices.
    /// Why there is none, and the way out; empty when there is one.
    [[nodiscard]] std::string reason(const InputFolders& folders = {}) const;
};

/// Event devices with a gamepad's buttons, and joystick devices.
[[nodiscard]] GamepadSearch look_for_gamepads(const InputFolders& folders = {});

/// Throws DeviceError with the reason when there is none.
void need_gamepad(const InputFolders& folders = {});

}  // namespace placode::haptics

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Devices as far as hints differ: which key, button or hand a step needs.

#include <cstdint>
#include <string_view>

namespace placode::haptics {

/// What a hand moves, as far as hints differ.
enum class HintDevice : uint8_t { kNone, kMouse, kKeyboard, kGamepad, kSpaceMouse, kArm };

/// Of a device as on the command line; scripts and replays need no hints.
[[nodiscard]] constexpr HintDevice hint_device(std::string_view name) noexcept {
    name = name.substr(0, name.find(':'));
    if (name == "mouse") return HintDevice::kMouse;
    if (name == "keyboard") return HintDevice::kKeyboard;
    if (name == "gamepad") return HintDevice::kGamepad;
    if (name == "spacemouse") return HintDevice::kSpaceMouse;
    for (const std::string_view arm : {"openhaptics", "haply", "avatar", "forcedimension"})
        if (name == arm) return HintDevice::kArm;
    return HintDevice::kNone;
}

}  // namespace placode::haptics

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a hand does on a device for what happens.

#include <string>
#include <string_view>
#include <vector>

namespace placode::haptics {

/// One line of the help: what happens, and what the hand does for it.
struct ControlHelp {
    std::string action;  ///< English, e.g. "Cut (yellow pedal)"; translated in ui.
    std::string input;   ///< e.g. "hold the left mouse button"
};

/// Controls of a device by name, in the order in which a beginner needs them. Empty for scripts and
/// unknown names.
[[nodiscard]] std::vector<ControlHelp> controls(std::string_view device);

}  // namespace placode::haptics

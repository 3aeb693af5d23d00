// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether this desktop wants things to move that need not move.

#include <filesystem>

namespace placode::ui {

/// False where PLACODE_MOTION=0, or where the desktop's settings switch animations off.
[[nodiscard]] bool motion_wanted();
/// What the settings under a folder like ~/.config say: GTK's and KDE's.
[[nodiscard]] bool motion_wanted_in(const std::filesystem::path& settings);

}  // namespace placode::ui

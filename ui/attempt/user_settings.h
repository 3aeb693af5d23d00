// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the simulator remembers from one attempt to the next, in $XDG_CONFIG_HOME/placode. A file
// that cannot be read or written costs nothing but the memory.

#include <filesystem>
#include <optional>
#include <string_view>

namespace placode::ui {

/// Path of a file of settings; its folder need not exist. Empty without a home.
[[nodiscard]] std::filesystem::path settings_file(std::string_view name);

/// Where the desktop keeps the user's pictures (XDG_PICTURES_DIR of user-dirs.dirs); the home
/// folder where it names none that is there.
[[nodiscard]] std::filesystem::path pictures_folder();

struct WindowSize {
    int width = 0, height = 0;  ///< Screen coordinates, as the desktop gives them.
};
/// Of the last attempt in a window; nothing where none is known or it makes no sense.
[[nodiscard]] std::optional<WindowSize> load_window_size();
void save_window_size(const WindowSize& size);

}  // namespace placode::ui

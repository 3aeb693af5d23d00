// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/user_settings.h"

#include <cstdlib>
#include <fstream>
#include <locale>
#include <system_error>

#include "ui/attempt/arguments.h"

namespace placode::ui {

std::filesystem::path settings_file(std::string_view name) {
    const char* set = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const std::filesystem::path folder =
        set != nullptr && *set != '\0'
            ? std::filesystem::path(set)
            : std::filesystem::path(home != nullptr ? home : ".") / ".config";
    return folder / "placode" / name;
}

std::optional<WindowSize> load_window_size() {
    std::ifstream in(settings_file("window"));
    in.imbue(std::locale::classic());
    WindowSize size;
    if (!(in >> size.width >> size.height) || !is_window_size(size.width, size.height))
        return std::nullopt;
    return size;
}

void save_window_size(const WindowSize& size) {
    if (!is_window_size(size.width, size.height)) return;
    std::error_code error;
    std::filesystem::create_directories(settings_file("window").parent_path(), error);
    std::ofstream out(settings_file("window"));
    out.imbue(std::locale::classic());
    out << size.width << ' ' << size.height << '\n';
}

}  // namespace placode::ui

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/user_settings.h"

#include <fstream>
#include <locale>
#include <string>
#include <system_error>

#include "sim/core/user_folders.h"
#include "ui/attempt/arguments.h"

namespace placode::ui {

namespace {

std::filesystem::path home() {
    const std::filesystem::path known = sim::home_folder();
    return known.empty() ? "." : known;
}

}  // namespace

std::filesystem::path settings_file(std::string_view name) {
    return sim::user_path(sim::UserFolder::kConfig, std::filesystem::path("placode") / name);
}

std::filesystem::path pictures_folder() {
    constexpr std::string_view kKey = "XDG_PICTURES_DIR=\"", kHome = "$HOME/";
    std::ifstream in(sim::user_path(sim::UserFolder::kConfig, "user-dirs.dirs"));
    for (std::string line; std::getline(in, line);) {
        const size_t end = line.rfind('"');
        if (!line.starts_with(kKey) || end < kKey.size()) continue;
        const std::string named = line.substr(kKey.size(), end - kKey.size());
        const std::filesystem::path folder = named.starts_with(kHome)
                                                 ? home() / named.substr(kHome.size())
                                                 : std::filesystem::path(named);
        std::error_code error;
        if (folder.is_absolute() && std::filesystem::is_directory(folder, error)) return folder;
    }
    return home();
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

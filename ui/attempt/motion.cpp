// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/motion.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <string>

#include "sim/core/user_folders.h"

namespace placode::ui {
namespace {

/// The value of `key = value` in a settings file, without spaces; empty when it is not there.
std::string setting(const std::filesystem::path& file, const std::string& key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        line.erase(std::remove_if(line.begin(), line.end(),
                                  [](char c) { return c == ' ' || c == '\t' || c == '\r'; }),
                   line.end());
        if (line.rfind(key + "=", 0) == 0) return line.substr(key.size() + 1);
    }
    return {};
}

}  // namespace

bool motion_wanted_in(const std::filesystem::path& settings) {
    for (const char* folder : {"gtk-4.0", "gtk-3.0"}) {
        const std::string gtk =
            setting(settings / folder / "settings.ini", "gtk-enable-animations");
        if (gtk == "false" || gtk == "0") return false;
    }
    const std::string kde = setting(settings / "kdeglobals", "AnimationDurationFactor");
    return kde != "0";
}

bool motion_wanted() {
    if (const char* wish = std::getenv("PLACODE_MOTION")) return std::string(wish) != "0";
    const std::filesystem::path settings = sim::user_folder(sim::UserFolder::kConfig);
    return settings.empty() || motion_wanted_in(settings);
}

}  // namespace placode::ui

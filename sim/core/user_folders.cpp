// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/user_folders.h"

#include <cstdlib>

namespace placode::sim {

namespace fs = std::filesystem;

namespace {

struct Place {
    const char* variable;
    const char* below_home;
};

Place place_of(UserFolder which) {
    switch (which) {
        case UserFolder::kConfig:
            return {"XDG_CONFIG_HOME", ".config"};
        case UserFolder::kData:
            return {"XDG_DATA_HOME", ".local/share"};
        case UserFolder::kCache:
            break;
    }
    return {"XDG_CACHE_HOME", ".cache"};
}

fs::path absolute_in(const char* variable) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    const fs::path path = value != nullptr ? value : "";
    return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path home_folder() { return absolute_in("HOME"); }

fs::path user_folder(UserFolder which) {
    const Place place = place_of(which);
    if (fs::path named = absolute_in(place.variable); !named.empty()) return named;
    const fs::path home = home_folder();
    return home.empty() ? home : home / place.below_home;
}

fs::path user_path(UserFolder which, const fs::path& below) {
    const fs::path folder = user_folder(which);
    return folder.empty() ? folder : folder / below;
}

}  // namespace placode::sim

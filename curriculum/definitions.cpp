// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/definitions.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#ifndef PLACODE_SOURCE_DIR
#define PLACODE_SOURCE_DIR "."
#endif

namespace placode::curriculum {

namespace fs = std::filesystem;

DefinitionError::DefinitionError(const std::string& file, const std::string& pointer,
                                 const std::string& problem)
    : std::runtime_error(file + ": " + (pointer.empty() ? "" : pointer + ": ") + problem),
      file_(file),
      pointer_(pointer) {}

fs::path data_folder() {
    if (const char* set = std::getenv("PLACODE_DATA"); set != nullptr && *set != '\0') return set;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path installed = program.parent_path().parent_path() / "share" / "placode";
        if (fs::is_directory(installed / "schemas", error)) return installed;
    }
    return fs::path(PLACODE_SOURCE_DIR) / "data";
}

std::vector<std::string> list_definitions(const std::string& kind) {
    std::vector<std::string> ids;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(data_folder() / kind, error)) {
        if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    }
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace placode::curriculum

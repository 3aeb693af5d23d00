// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/definitions.h"

#include <dlfcn.h>

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

namespace {

/// share/placode of the prefix in which `file` lies, so many folders above it.
fs::path installed(fs::path file, int up) {
    for (int i = 0; i < up; ++i) file = file.parent_path();
    return file / "share" / "placode";
}

bool has_schemas(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "schemas", error);
}

}  // namespace

fs::path data_folder() {
    std::error_code error;
    // Absolute, because a definition names others beside it.
    if (const char* set = std::getenv("PLACODE_DATA"); set != nullptr && *set != '\0') {
        const fs::path folder = fs::absolute(set, error);
        return error ? fs::path(set) : folder;
    }
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error && has_schemas(installed(program, 2))) return installed(program, 2);
    // In libplacode.so the program is somebody else's: bin/python3, say. A library lies in lib/ or
    // in lib/MACHINE/.
    Dl_info here{};
    if (::dladdr(reinterpret_cast<const void*>(&data_folder), &here) != 0 && here.dli_fname) {
        const fs::path library = fs::canonical(here.dli_fname, error);
        for (int up = 2; !error && up <= 3; ++up)
            if (has_schemas(installed(library, up))) return installed(library, up);
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

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file that a command writes whole, and whether it can, before the hours of work that it is of.

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "ui/cli/cli.h"

namespace placode::cli {

/// Throws InputError, which begins with `what`, unless `folder` can be made and written in.
inline void need_place(const std::string& what, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path there = fs::absolute(folder, error).lexically_normal();
    // A link that leads nowhere is there, too.
    while (there.has_relative_path() && !fs::exists(fs::symlink_status(there, error)))
        there = there.parent_path();
    if (!fs::is_directory(there, error))
        throw InputError(what + " (" + there.string() + " is no folder); choose another place");
    if (::access(there.c_str(), W_OK | X_OK) != 0)
        throw InputError(what + " (" + there.string() + ": " +
                         std::generic_category().message(errno) + "); choose another place");
}

/// Looks whether a folder can be made and written in, and makes nothing: what is refused later
/// leaves nothing behind. Empty = not asked for. @throws InputError naming option and folder.
inline void need_writable_folder(const std::string& option, const std::string& folder) {
    if (!folder.empty()) need_place(option + " " + folder + ": cannot be written", folder);
}

/// The same of a file, which may be there already.
inline void need_writable_file(const std::string& option, const std::string& file) {
    namespace fs = std::filesystem;
    if (file.empty()) return;
    const std::string what = option + " " + file + ": cannot be written";
    std::error_code error;
    if (fs::is_directory(file, error))
        throw InputError(what + " (it is a folder); expected a file");
    if (!fs::exists(file, error))
        need_place(what, fs::absolute(file, error).parent_path());
    else if (::access(file.c_str(), W_OK) != 0)
        throw InputError(what + " (" + std::generic_category().message(errno) +
                         "); choose another place");
}

/// The same of a file in a folder that is there: the command makes none.
inline void need_file_place(const std::string& option, const std::string& file) {
    namespace fs = std::filesystem;
    if (file.empty()) return;
    std::error_code error;
    const fs::path folder = fs::absolute(file, error).parent_path();
    if (!fs::is_directory(folder, error))
        throw InputError(option + " " + file + ": cannot be written (" + folder.string() +
                         " is no folder); choose another place");
    need_writable_file(option, file);
}

/// The same of a file that is never written over.
inline void need_new_file(const std::string& option, const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (file.empty()) return;
    if (fs::exists(fs::symlink_status(file, error)))
        throw InputError(option + ": " + file +
                         " exists and is not overwritten; give another name");
    need_file_place(option, file);
}

/// @throws InputError naming the file when it cannot be written to its end.
inline void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.flush();
    if (!out) throw InputError(path.string() + ": cannot be written; choose another place");
}

}  // namespace placode::cli

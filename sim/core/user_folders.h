// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a user's files lie, for what does not have Qt's QStandardPaths.
// Source: XDG Base Directory Specification 0.8, https://specifications.freedesktop.org/basedir-spec

#include <filesystem>

namespace placode::sim {

enum class UserFolder { kConfig, kData, kCache };

/// $HOME; empty where it is not set or names no absolute path.
[[nodiscard]] std::filesystem::path home_folder();

/// $XDG_CONFIG_HOME, $XDG_DATA_HOME or $XDG_CACHE_HOME; where one is not set, empty or relative
/// (the specification: "consider the path invalid and ignore it") ~/.config, ~/.local/share or
/// ~/.cache. Empty where there is no home either. It need not exist.
[[nodiscard]] std::filesystem::path user_folder(UserFolder which);

/// `below` in that folder; empty where the folder is not known, so that nothing is read from or
/// written to wherever the program was started.
[[nodiscard]] std::filesystem::path user_path(UserFolder which, const std::filesystem::path& below);

}  // namespace placode::sim

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file that a command writes whole.

#include <filesystem>
#include <fstream>

#include "ui/cli/cli.h"

namespace placode::cli {

/// @throws InputError naming the file when it cannot be written to its end.
inline void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.flush();
    if (!out) throw InputError(path.string() + ": cannot be written; choose another place");
}

}  // namespace placode::cli

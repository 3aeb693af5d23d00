// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that are whole after a power cut, and take each other's place in one step.

#include <string>

namespace placode::db {

/// What was written to the file is on the disk when it returns. Not for a file that SQLite has open
/// in this process: closing it here would drop SQLite's locks. Throws fs::filesystem_error.
void sync_file(const std::string& path);

/// What was created, renamed or removed in the folder of `path` is on the disk when it returns.
void sync_folder_of(const std::string& path);

/// `fresh` takes the place of `path`, and the file that was there is kept as `aside`: at every
/// moment there is a whole file at `path`. Everything is on the disk when it returns. Where the
/// file system cannot exchange two names, `aside` becomes a copy first. Throws
/// fs::filesystem_error.
/// @pre All three are in one folder; `fresh` and `path` exist, `aside` does not.
void replace_file(const std::string& fresh, const std::string& path, const std::string& aside);

}  // namespace placode::db

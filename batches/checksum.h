// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SHA-256 of what goes into a batch and of what comes out, and files that are whole or not there.

#include <cstdint>
#include <filesystem>
#include <string>

namespace placode::batches {

/// In hexadecimal, as `sha256sum` prints it.
[[nodiscard]] std::string sha256(const std::string& bytes);
/// Throws BatchError naming the file when it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

/// "0x" and sixteen digits: a state hash.
[[nodiscard]] std::string hash_text(uint64_t hash);

/// Throws BatchError naming the file.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);
/// Under a temporary name, on the disk, then renamed: whole or not there. Throws BatchError.
void write_whole(const std::filesystem::path& path, const std::string& text);

}  // namespace placode::batches

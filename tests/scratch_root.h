// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where tests make their folders.

#include <sys/statvfs.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>

namespace placode::test {

/// In memory where there is room, because a store commits often and a server makes three hundred
/// files for a database: on a disk such tests wait, and the kernel works, several times as long.
/// TMPDIR, where it is set, is taken as it is.
inline std::filesystem::path scratch_root() {
    static const char* const kMemory = "/dev/shm";
    constexpr uint64_t kRoomBytes = uint64_t{2} << 30;
    struct statvfs memory {};
    const bool fits = ::statvfs(kMemory, &memory) == 0 && (memory.f_flag & ST_NOEXEC) == 0 &&
                      uint64_t{memory.f_bavail} * memory.f_frsize >= kRoomBytes &&
                      ::access(kMemory, W_OK) == 0;
    if (fits && std::getenv("TMPDIR") == nullptr) return kMemory;
    return std::filesystem::temp_directory_path();
}

}  // namespace placode::test

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/disk_room.h"

#include <sys/statvfs.h>

#include <filesystem>
#include <optional>

#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr int64_t kReserveBytes = int64_t{64} << 20;  ///< Some attempts with their recordings.

/// nullopt: the folder cannot be asked; writing into it tells.
std::optional<int64_t> room_of(const StoreOptions& options, const std::string& path) {
    if (options.room_bytes) return options.room_bytes;
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    struct statvfs disk {};
    if (::statvfs(folder.c_str(), &disk) != 0) return std::nullopt;
    return static_cast<int64_t>(uint64_t{disk.f_bavail} * disk.f_frsize);
}

/// About what a copy takes. A dump is compressed, which makes recordings, most of it, no smaller:
/// they are packed already. It holds no indexes.
int64_t size_of_copy(Connection& connection) {
    Statement query(connection,
                    connection.is_sqlite()
                        ? "SELECT c.page_count * s.page_size FROM pragma_page_count c, "
                          "pragma_page_size s"
                        : "SELECT CAST(COALESCE(SUM(pg_table_size(oid)), 0) AS BIGINT) FROM "
                          "pg_class WHERE relkind = 'r' AND relnamespace = "
                          "'public'::regnamespace");
    return query.run().next() ? query.integer(0) : 0;
}

}  // namespace

void need_room_for_copy(StoreContext& context, const std::string& path) {
    const auto room = room_of(context.options, path);
    if (!room) return;
    const int64_t needed = size_of_copy(context.connection) + kReserveBytes;
    if (*room >= needed) return;
    constexpr int64_t kMegabyte = 1'000'000;
    // scheduled-backup knows the refusal by its words.
    context.connection.fail(
        StoreError::Kind::kRefused,
        Said::that("only %1 MB are free there, and the copy needs %2 MB; make room, or give "
                   "another place")
            .with(*room / kMegabyte)
            .with((needed + kMegabyte - 1) / kMegabyte));
}

}  // namespace placode::db

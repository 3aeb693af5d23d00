// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/checked_copy.h"

#include <filesystem>

#include "db/durable_file.h"
#include "db/foreign_store.h"
#include "db/sqlite_file.h"
#include "db/store_context.h"

namespace placode::db {

void keep_checked_copy(StoreContext& context, const std::string& path,
                       const std::function<std::string(const std::string&)>& deeper) {
    Connection& connection = context.connection;
    const std::string part = path + kPartSuffix, failed = path + kFailedSuffix;
    // Whatever fails leaves no copy that nobody knows of, and the same name may be given again.
    bool named = false;
    const auto forget = [&] {
        forget_sqlite_file(part);
        if (named) forget_sqlite_file(path);
    };
    try {
        remove_sqlite_file(part);
        copy_sqlite_store(connection, part);
        std::string problem = copy_problem(part, context.options.migrations);
        if (problem.empty() && deeper) problem = deeper(part);
        if (!problem.empty()) {
            std::filesystem::rename(part, failed);
            connection.fail(StoreError::Kind::kDamaged,
                            "the copy does not pass its check (" + problem + ") and is kept as " +
                                failed + "; check the store with `placodectl check`");
        }
        std::filesystem::rename(part, path);
        named = true;
        sync_folder_of(path);
        forget_sqlite_file(part);  // A log that is folded in and that SQLite could not remove.
    } catch (const std::filesystem::filesystem_error& error) {
        forget();
        connection.fail(StoreError::Kind::kUnavailable,
                        "cannot write " + path + " (" + error.code().message() +
                            "); the store is unchanged, give another place");
    } catch (...) {
        forget();
        throw;
    }
}

}  // namespace placode::db

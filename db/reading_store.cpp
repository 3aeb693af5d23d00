// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reading_store.h"

#include <QCoreApplication>
#include <cassert>

#include "db/schema.h"
#include "db/sqlite_file.h"
#include "db/station_role.h"
#include "db/store_context.h"
#include "db/store_place.h"

namespace placode::db {
namespace {

/// Older tables are for a program that may change them.
void need_present_tables(Connection& connection, const StoreOptions& options) {
    const auto& set = options.migrations;
    migrate(connection, set.empty() ? embedded_migrations() : set, [&connection] {
        connection.fail(StoreError::Kind::kOther,
                        "its tables are older than this program, which only reads; open it once "
                        "with placodectl of the same version");
    });
}

}  // namespace

std::unique_ptr<Store> open_for_reading(const std::string& url, int64_t account_id,
                                        const StoreOptions& options) {
    assert(QCoreApplication::instance() != nullptr);
    const StoreUrl parsed = parse_store_url(url);
    // Before the connection: SQLite would make a file that is not there.
    if (parsed.engine == Engine::kSqlite) need_known_store(parsed.path, true, "open");
    auto context = std::make_unique<StoreContext>(parsed, options);
    Connection& connection = context->connection;
    connection.begin_operation("open");
    connection.execute(connection.is_sqlite() ? "PRAGMA query_only = ON"
                                              : "SET default_transaction_read_only = on");
    // Also after a server has dropped the connection, and it was opened anew.
    connection.watch_transactions(
        [&connection] {
            connection.roll_back();
            connection.fail(StoreError::Kind::kRefused, "it was opened for reading only");
        },
        {});
    need_settled(connection);
    need_present_tables(connection, options);
    if (options.station) need_station_role(connection, options.service);
    context->become(account_id);
    context->server.resume(account_id);  // To a server it is who has signed in in this program.
    return std::make_unique<Store>(std::move(context));
}

}  // namespace placode::db

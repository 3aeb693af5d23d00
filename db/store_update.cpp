// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_update.h"

#include <QDateTime>
#include <QUuid>
#include <optional>
#include <string>

#include "db/checked_copy.h"
#include "db/disk_room.h"
#include "db/schema.h"
#include "db/sqlite_file.h"
#include "db/station_guard.h"
#include "db/station_role.h"
#include "db/store_context.h"
#include "db/store_place.h"

namespace placode::db {
namespace {

// Two programs may update a store within one millisecond, so the name also says which.
std::string file_stamp() {
    return QDateTime::currentDateTimeUtc().toString("yyyyMMdd'T'HHmmsszzz'Z'").toStdString() + "-" +
           QUuid::createUuid().toString(QUuid::WithoutBraces).left(8).toStdString();
}

void tell(const StoreContext& context, const UpdateStep& step) {
    if (context.options.updating) context.options.updating(step);
}

/// After an update: a store from before there were seals gets them once. Not one that this computer
/// has signed before: its trail was taken away, and check() has to say so.
void seal_what_was_there(StoreContext& context) {
    if (context.server.guards()) {
        // The owner of the tables has sealed what was there. A trail that is not there is not the
        // one that this computer remembers.
        if (end_of_trail(context.connection).entry == 0 && !any_account(context.connection))
            context.station.forget();
        return;
    }
    const auto sealed = [&context] {
        return Statement(context.connection,
                         "SELECT id FROM audit WHERE seals <> '' OR station <> '' ORDER BY id "
                         "DESC LIMIT 1")
            .run()
            .next();
    };
    if (sealed()) return;
    const auto empty = [&context](const char* table) {
        return !Statement(context.connection, std::string("SELECT id FROM ") + table + " LIMIT 1")
                    .run()
                    .next();
    };
    if (empty("audit") && empty("accounts")) {
        context.station.forget();  // of the store that was at this address before
        return;
    }
    if (!context.station.heads().empty()) return;
    tell(context, {UpdatePart::kSeals, {}});
    UnitOfWork work(context.connection);
    context.lock_trail();
    if (!sealed()) context.seal_the_unsealed();
    work.commit();
}

/// A store of an older program is about to change: what is kept of it.
void keep_older(StoreContext& context) {
    Connection& connection = context.connection;
    if (context.options.leave_older)
        connection.fail(StoreError::Kind::kOlder, "its tables are older than this program");
    const std::string& path = connection.url().path;
    if (!connection.is_sqlite() || path == ":memory:")
        return tell(context, {UpdatePart::kTables, {}});
    tell(context, {UpdatePart::kCheck, {}});
    const std::string problem = sqlite_integrity_problem(connection);
    if (!problem.empty())
        connection.fail(StoreError::Kind::kDamaged,
                        "not migrated, because it is damaged (" + problem +
                            "); restore a backup with `placodectl restore FILE`");
    need_room_for_copy(context, path);
    tell(context, {UpdatePart::kCopy, {}});
    const std::string copy = path + ".before-update-" + file_stamp();
    keep_checked_copy(context, copy);
    tell(context, {UpdatePart::kTables, copy});
}

}  // namespace

void bring_up_to_date(StoreContext& context) {
    Connection& connection = context.connection;
    connection.begin_operation("open");
    if (connection.is_sqlite()) claim_sqlite_file(connection);
    need_settled(connection);
    connection.explain_refusals([&connection] {
        const auto moved = moved_meanwhile(connection);
        return moved ? moved : std::optional<Said>(guard_refusal());
    });
    const auto& set = context.options.migrations;
    const bool changed = migrate(connection, set.empty() ? embedded_migrations() : set,
                                 [&context] { keep_older(context); });
    renew_station_role(connection, changed);
    if (context.options.station) need_station_role(connection, context.options.service);
    seal_what_was_there(context);
}

}  // namespace placode::db

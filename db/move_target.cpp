// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/move_target.h"

#include <algorithm>
#include <filesystem>

#include "db/durable_file.h"
#include "db/foreign_store.h"
#include "db/held_store.h"
#include "db/schema.h"
#include "db/sqlite_file.h"
#include "db/station_role.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;
using State = StorePlace::State;

bool is_filled(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path) && (fs::is_directory(path) || fs::file_size(path, ignored) > 0);
}

bool has_table(const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// "begun on 2026-01-02, with 12 accounts": by which people know a store.
std::string described(Connection& connection) {
    std::string begun = "that was never used";
    {
        Statement first(connection, "SELECT at_utc FROM audit ORDER BY id LIMIT 1");
        if (first.run().next()) begun = "begun on " + first.text(0).substr(0, 10);
    }
    Statement count(connection, "SELECT COUNT(*) FROM accounts");
    const int64_t accounts = count.run().next() ? count.integer(0) : 0;
    return begun + ", with " + std::to_string(accounts) +
           (accounts == 1 ? " account" : " accounts");
}

bool has_rows(Connection& connection, const std::vector<StoreTable>& tables) {
    return std::any_of(tables.begin(), tables.end(), [&](const StoreTable& table) {
        return Statement(connection, "SELECT 1 FROM " + table.name + " LIMIT 1").run().next();
    });
}

/// Of the tables, or of the room for them.
void need_owner_there(Connection& connection) {
    if (connection.is_sqlite()) return;
    bool may = owns_tables(connection);
    if (names_of_tables(connection).empty()) {
        Statement query(
            connection,
            "SELECT CASE WHEN has_schema_privilege('public', 'CREATE') THEN 1 ELSE 0 END");
        may = query.run().next() && query.integer(0) != 0;
    }
    if (!may) connection.fail(Kind::kRefused, kOnlyTheOwner);
}

}  // namespace

MoveTarget::MoveTarget(const StoreUrl& url, std::string store, const StoreOptions& options)
    : url_(url),
      store_(std::move(store)),
      operation_("move to " + place_name(url)),
      options_(options) {}

StoreUrl MoveTarget::working() const {
    if (url_.engine != Engine::kSqlite) return url_;
    StoreUrl url = url_;
    url.path += ".moving";
    url.shown = "sqlite:" + url.path;
    return url;
}

void MoveTarget::need_free() {
    underway_ = false;
    url_.engine == Engine::kSqlite ? needFreeFile() : needFreeServer();
}

void MoveTarget::needFreeFile() {
    const auto refuse = [this](const std::string& why) {
        throw StoreError(Kind::kConflict, operation_ + ": " + why);
    };
    if (is_filled(url_.path)) {
        if (fs::is_directory(url_.path) || !is_marked_as_store(url_.path))
            refuse("there is another program's file; give another place");
        need_own_schema(url_.path, operation_, options_.migrations);
        Connection there(url_);
        const auto place = place_of(there);
        // The store as it was when it moved away: it is kept under another name.
        if (!place || place->state != State::kMoved || place->store != store_)
            refuse("there is another store, " + described(there) +
                   "; give another place, or move its file away first");
    }
    const StoreUrl part = working();
    if (!is_filled(part.path)) return;
    std::optional<StorePlace> place;
    if (is_marked_as_store(part.path)) {
        need_own_schema(part.path, operation_, options_.migrations);
        Connection there(part);
        place = place_of(there);
    }
    if (!place || place->store != store_)
        refuse("there is an unfinished move of another store, " + part.path +
               "; finish it, or move that file away first");
    underway_ = true;
}

void MoveTarget::needFreeServer() {
    Connection there(url_);
    there.begin_operation("move to");
    need_owner_there(there);
    const auto names = names_of_tables(there);
    if (names.empty()) return;
    if (const auto place = place_of(there)) {
        if (place->store != store_)
            there.fail(Kind::kConflict, "there is an unfinished move of another store, from " +
                                            place->from + "; give another database");
        if (place->state == State::kMoved)
            there.fail(Kind::kConflict,
                       "there is still this store as it was when it moved away; give an empty "
                       "database, or rename that one on the server");
        underway_ = true;
        return;
    }
    if (!has_table(names, kMigrationsTable))
        there.fail(Kind::kConflict, "there are another program's tables; give an empty database");
    // Tables that `station role --apply` made, perhaps of an older version, without a row.
    std::vector<StoreTable> tables;
    for (const std::string& name : names)
        if (name != kMigrationsTable) tables.emplace_back().name = name;
    if (has_rows(there, tables))
        there.fail(Kind::kConflict,
                   "there is another store, " + described(there) + "; give an empty database");
}

std::unique_ptr<StoreContext> MoveTarget::open(const StorePlace& place) {
    const StoreUrl part = working();
    if (part.engine == Engine::kSqlite) prepare_sqlite_file(part.path, "move to");
    auto context = std::make_unique<StoreContext>(part, options_);
    // What was remembered is the end of an earlier store's trail here.
    context->station.forget();
    Connection& connection = context->connection;
    connection.begin_operation("move to");
    if (part.engine == Engine::kSqlite) claim_sqlite_file(connection);
    need_owner_there(connection);
    // Before the tables: whoever finds them empty would become administrator.
    if (const auto there = place_of(connection); there && there->store != store_) {
        connection.fail(Kind::kConflict, "another store has begun to move there meanwhile");
    } else if (!there) {
        UnitOfWork work(connection);
        set_place(connection, place);
        work.commit();
    }
    migrate(connection, options_.migrations.empty() ? embedded_migrations() : options_.migrations,
            [] {});
    return context;
}

std::unique_ptr<StoreContext> MoveTarget::open_empty(std::unique_ptr<StoreContext> old,
                                                     const StorePlace& place) {
    if (url_.engine == Engine::kSqlite) {
        old.reset();
        remove_sqlite_file(working().path);
        return open(place);
    }
    Connection& connection = old->connection;
    const auto tables = store_tables(connection, options_, kPlaceTable);
    std::vector<std::string> names;
    for (const StoreTable& table : tables) names.push_back(table.name);
    UnitOfWork work(connection);
    // The trail's guards refuse it, and what is here is no trail yet.
    for (const std::string& name : names)
        connection.execute("ALTER TABLE " + name + " DISABLE TRIGGER USER");
    connection.execute("TRUNCATE " + listed(names) + " RESTART IDENTITY");
    for (const std::string& name : names)
        connection.execute("ALTER TABLE " + name + " ENABLE TRIGGER USER");
    set_place(connection, place);
    work.commit();
    return old;
}

std::string MoveTarget::finish() {
    if (url_.engine == Engine::kSqlite) return finishFile();
    finishServer();
    return {};
}

void MoveTarget::finishServer() {
    Connection connection(url_);
    connection.begin_operation("move to");
    // Whoever finds no mark has found a store that is finished.
    if (!place_of(connection) && first_chain(connection) == store_) return;
    if (!place_of(connection) || place_of(connection)->store != store_)
        connection.fail(Kind::kConflict, "the store that was moved there is gone");
    renew_station_role(connection, true);
    UnitOfWork work(connection);
    forget_place(connection);
    work.commit();
}

std::string MoveTarget::finishFile() {
    const StoreUrl part = working();
    // Somebody may have put another file there since need_free().
    need_own_schema(is_filled(part.path) ? part.path : url_.path, operation_, options_.migrations);
    if (!is_filled(part.path)) {
        Connection there(url_);
        there.begin_operation("move to");
        if (place_of(there) || first_chain(there) != store_)
            there.fail(Kind::kConflict, "the store that was moved there is gone");
        return {};
    }
    {
        Connection there(part);
        there.begin_operation("move to");
        if (first_chain(there) != store_)
            there.fail(Kind::kConflict, "the store that was moved there is gone");
        UnitOfWork work(there);
        forget_place(there);
        work.commit();
    }
    need_folded_log(part.path, operation_);
    try {
        Station(part).forget();
        Station(url_).forget();
        const std::string aside = putOldFileAside();
        sync_file(part.path);
        fs::rename(part.path, url_.path);
        sync_folder_of(url_.path);
        mark_store(url_.path);
        return aside;
    } catch (const fs::filesystem_error& error) {
        throw StoreError(Kind::kUnavailable, operation_ + ": " + error.what());
    }
}

std::string MoveTarget::putOldFileAside() {
    if (!is_filled(url_.path)) return {};
    std::string stamp;
    {
        need_own_schema(url_.path, operation_, options_.migrations);
        Connection old(url_);
        old.begin_operation("move to");
        const auto place = place_of(old);
        if (!place || place->state != State::kMoved || place->store != store_)
            old.fail(Kind::kConflict,
                     "there is another store, " + described(old) + "; move its file away first");
        for (const char letter : place->at_utc)
            if (letter != '-' && letter != ':' && letter != '.') stamp += letter;
    }
    const std::string aside = url_.path + ".moved-" + stamp;
    const HeldStore held(url_, operation_);
    put_log_aside(url_.path, aside);
    fs::rename(url_.path, aside);
    sync_folder_of(url_.path);
    return aside;
}

}  // namespace placode::db

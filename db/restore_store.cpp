// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A backup takes the place of an embedded store. At every moment there is one whole store.

#include <QDateTime>
#include <filesystem>

#include "db/durable_file.h"
#include "db/ended_again.h"
#include "db/ended_meanwhile.h"
#include "db/erasure.h"
#include "db/foreign_store.h"
#include "db/held_store.h"
#include "db/said.h"
#include "db/sqlite_file.h"
#include "db/station.h"
#include "db/store.h"
#include "db/store_url.h"
#include "db/trail_head.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;

void prove(const std::string& copy, const std::string& backup_path, const std::string& operation,
           const std::string& actor, const std::string& replaced_path) {
    if (!is_marked_as_store(copy))
        throw StoreError(Kind::kDamaged,
                         operation + ": the file is not a backup of a store; nothing was changed");
    // Anybody may have made it: nothing is run and nothing written before all of it was read.
    need_own_schema(copy, operation);
    if (const std::string problem = copy_problem(copy); !problem.empty())
        throw StoreError(Kind::kDamaged, operation + ": the backup is damaged (" + problem +
                                             "); nothing was changed");
    const bool without_signature = !has_signed_entries(copy);  // Opening it may add one.
    const auto store = open_store("sqlite:" + copy);
    auto problems = store->check();
    const std::string stated = head_file_of(backup_path);
    if (fs::exists(stated)) store->audit().check_head(read_trail_head(stated), problems);
    if (!problems.empty())
        throw StoreError(Kind::kDamaged, operation + ": the backup is damaged (" +
                                             problems.front() + "); nothing was changed");
    // A person who asked to be erased does not come back with a backup, nor do the records of a
    // participant who withdrew. Who can write to that store's file can name anybody there.
    const auto meanwhile = ended_meanwhile(
        replaced_path,
        {store->audit().head().store, store->audit().trusted_keys(), without_signature});
    const bool was_here = fs::exists(replaced_path) || fs::exists(mark_of_store(replaced_path));
    store->audit().write(actor, "store.restore", backup_path,
                         meanwhile || !was_here ? "" : kErasuresUnknown);
    if (!meanwhile) return;
    erase_again(*store, people_of(meanwhile->people));
    end_again(*store, ended_records(meanwhile->records), meanwhile->reasons);
    name_doubted(*store, actor, meanwhile->doubted);
}

}  // namespace

std::string restore_store(const std::string& url, const std::string& backup_path,
                          const std::string& actor) {
    const StoreUrl target = parse_store_url(url);
    const std::string operation = "restore " + backup_path + " to " + target.shown;
    if (target.engine != Engine::kSqlite || target.path == ":memory:")
        throw StoreError(Kind::kRefused, operation + ": ",
                         Said::that("only an embedded store is restored from a file; use "
                                    "pg_restore on the server"));
    if (fs::is_directory(backup_path))
        throw StoreError(Kind::kDamaged, operation + ": this is a folder");
    if (!fs::is_regular_file(backup_path))
        throw StoreError(Kind::kNotFound, operation + ": there is no such backup");
    // 1. The backup is proved on a copy, which becomes the new store: it stays as it is itself.
    const std::string fresh = target.path + kRestoringSuffix;
    const Station of_fresh(parse_store_url("sqlite:" + fresh));
    const auto forget_half_made = [&] {
        forget_sqlite_file(fresh);
        try {
            of_fresh.forget();
        } catch (const StoreError&) {
            // The next restore says it.
        }
    };
    std::string aside;
    try {
        remove_sqlite_file(fresh);
        // How far the trail of a copy went that was killed: this one begins behind it.
        of_fresh.forget();
        prepare_sqlite_file(fresh, operation);  // Folder, and file with mode 0600.
        fs::copy_file(backup_path, fresh, fs::copy_options::overwrite_existing);
        fs::permissions(fresh, fs::perms::owner_read | fs::perms::owner_write);
        prove(fresh, backup_path, operation, actor, target.path);
        need_folded_log(fresh, operation);  // Else whoever was erased would be back.
        // The backup's trail ends earlier, and that is right. Before the exchange: a kill in
        // between leaves a computer that remembers nothing, never one that suspects.
        Station(target).forget();
        of_fresh.forget();
        // 2. It takes the place of the old store, which is kept.
        if (fs::exists(target.path)) {
            const HeldStore held(target, operation);
            aside =
                target.path + ".replaced-" +
                QDateTime::currentDateTimeUtc().toString("yyyyMMdd'T'HHmmsszzz'Z'").toStdString();
            put_log_aside(target.path, aside);
            replace_file(fresh, target.path, aside);
        } else {
            sync_file(fresh);
            fs::rename(fresh, target.path);
            sync_folder_of(target.path);
        }
        forget_sqlite_file(fresh);  // A shared memory that SQLite could not remove.
        mark_store(target.path);
    } catch (const fs::filesystem_error& error) {
        forget_half_made();
        throw StoreError(Kind::kUnavailable, operation + ": " + error.what());
    } catch (...) {
        forget_half_made();
        throw;
    }
    return aside;
}

}  // namespace placode::db

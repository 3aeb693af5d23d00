// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The store: users, attempts, recordings, answers, audit. SQLite embedded or PostgreSQL for a
// centre, one code over Qt Sql. One Store per thread. Every change is one transaction.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/accounts.h"
#include "db/attempts.h"
#include "db/audit.h"
#include "db/courses.h"
#include "db/definitions.h"
#include "db/groups.h"
#include "db/norms.h"
#include "db/records.h"
#include "db/reviews.h"
#include "db/store_check.h"
#include "db/store_error.h"
#include "db/store_move.h"
#include "db/store_options.h"
#include "db/studies.h"
#include "db/study_records.h"

namespace placode::db {

struct StoreContext;

/// One open store. What it can do lies in its parts, each in a header of its name.
///
/// It works for somebody, and every method of every part asks the table of db/access.h whether
/// that one may, and throws kRefused. A store that was just opened works for the program that
/// opened it, which may all. From there its rights only become fewer: act_for() and a sign-in make
/// it an account's, sign_out() nobody's, and only signing in leads on from nobody. What an account
/// may is looked up at every call: roles that were taken away, and an account that was closed,
/// count at once. Who owns the file, or the database, needs no store to read it (SECURITY.md).
class Store final {
 public:
    /// For open_store().
    explicit Store(std::unique_ptr<StoreContext> context);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// The name of the program, under which its changes are written into the audit trail, each in
    /// the transaction of the change. At first: "unknown". Throws kRefused once the store works for
    /// an account or for nobody.
    void act_as(const std::string& actor);
    /// From now on for this account, as if it had signed in, because the program knows that it has:
    /// for a second store of the same session. Throws kRefused unless it works for the program, or
    /// for this account already.
    void act_for(int64_t account_id);
    /// From now on for nobody: who may sign in, take up an invitation and, where there is no
    /// account, make the first administrator.
    void sign_out();

    [[nodiscard]] Accounts& accounts() noexcept { return accounts_; }
    [[nodiscard]] Attempts& attempts() noexcept { return attempts_; }
    [[nodiscard]] Norms& norms() noexcept { return norms_; }
    [[nodiscard]] Groups& groups() noexcept { return groups_; }
    [[nodiscard]] Courses& courses() noexcept { return courses_; }
    [[nodiscard]] Reviews& reviews() noexcept { return reviews_; }
    [[nodiscard]] Definitions& definitions() noexcept { return definitions_; }
    [[nodiscard]] Studies& studies() noexcept { return studies_; }
    [[nodiscard]] StudyRecords& records() noexcept { return records_; }
    [[nodiscard]] Audit& audit() noexcept { return audit_; }

    std::vector<std::string> check();  ///< Problems found; empty = sound.
    /// The same, to be stopped on its way. nullopt: it was, and nothing is known of the store.
    [[nodiscard]] std::optional<std::vector<std::string>> check(const CheckOptions& options);
    /// Why the log-in of a centre's server can do more than a station should (db/station_role.h).
    [[nodiscard]] std::vector<std::string> role_problems();
    /// On a server, with the log-in of the tables' owner: gives the group for stations its rights.
    /// Throws kRefused where that log-in may not.
    void give_station_role();
    /// SQLite: a consistent copy, which counts when check() finds nothing in it; else it stays as
    /// PATH.failed and kDamaged is thrown.
    void backup(const std::string& path);
    /// Moves the whole store to another place: a server's, or a file; `url` as for open_store(), on
    /// a server with the log-in of the tables' owner. All rows are compared before it counts, and
    /// until then nothing is changed here. Killed or stopped at any moment, the same call goes on;
    /// behind the closing of this place finish_move() does. Throws kConflict where the new place is
    /// not free, kDamaged where this store is not sound or the copy is not the same. When it
    /// has moved, nothing more can be changed through this Store.
    MoveReport move_to(const std::string& url, const MoveOptions& options = {});
    [[nodiscard]] std::string url() const;  ///< For people: without the password.

 private:
    std::unique_ptr<StoreContext> context_;  ///< Before the parts, which refer to it.
    Accounts accounts_;
    Attempts attempts_;
    Norms norms_;
    Groups groups_;
    Courses courses_;
    Reviews reviews_;
    Definitions definitions_;
    Studies studies_;
    StudyRecords records_;
    Audit audit_;
};

/// "sqlite:PATH", "sqlite::memory:" or "postgresql://user@host:port/name", with the options of
/// db/store_url.h behind it. Creates (folder 0700, file 0600) and migrates; an existing SQLite file
/// is checked and copied, and the copy checked, before it is migrated. A file that is not a Placode
/// store, or is damaged, is not touched; one that was here and is gone is not made anew (kMissing).
/// Throws StoreError.
/// @pre A QCoreApplication exists: Qt finds its database drivers through it.
[[nodiscard]] std::unique_ptr<Store> open_store(const std::string& url,
                                                const StoreOptions& options = {});

/// Puts a backup in the place of an embedded store in one step: whenever it is killed, there is the
/// old store or the new one. The old file is kept beside it. Returns where ("" when there was
/// none). Throws kLocked when a program uses the store, kDamaged or kTooNew for the backup; the
/// store is then as it was.
std::string restore_store(const std::string& url, const std::string& backup_path,
                          const std::string& actor = "restore");

/// Whether an embedded store with accounts has been at this address, by the mark beside its file.
[[nodiscard]] bool store_was_here(const std::string& url);

/// "sqlite:" + the user's data folder + "/placode.db" (the folder is created by open_store).
[[nodiscard]] std::string default_store_url();

}  // namespace placode::db

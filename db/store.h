// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The store: users, attempts, recordings, answers, audit. SQLite embedded or PostgreSQL for a
// centre, one code over Qt Sql. One Store per thread. Every change is one transaction.

#include <memory>
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
#include "db/store_error.h"
#include "db/store_options.h"
#include "db/studies.h"
#include "db/study_records.h"

namespace placode::db {

struct StoreContext;

/// One open store. What it can do lies in its parts, each in a header of its name.
class Store final {
 public:
    /// For open_store().
    explicit Store(std::unique_ptr<StoreContext> context);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Every change is written into the audit trail in its own transaction, under this name. A
    /// successful sign-in sets it to the login. Before: "unknown".
    void act_as(const std::string& actor);

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
    /// SQLite: a consistent copy, which counts when check() finds nothing in it; else it stays as
    /// PATH.failed and kDamaged is thrown.
    void backup(const std::string& path);
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

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Opening, health and backup of a store.

#include "db/store.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <cassert>
#include <filesystem>

#include "db/checked_copy.h"
#include "db/disk_room.h"
#include "db/new_store.h"
#include "db/password.h"
#include "db/server_dump.h"
#include "db/sqlite_file.h"
#include "db/station_role.h"
#include "db/store_context.h"
#include "db/store_update.h"

namespace placode::db {
namespace {

/// What the whole check says about a copy. @param head where its trail ends
std::string first_problem(const std::string& path, const StoreOptions& options,
                          TrailHead* head = nullptr) {
    StoreUrl url;
    url.path = path;
    url.shown = "sqlite:" + path;
    Store copy(std::make_unique<StoreContext>(url, options));
    const auto problems = copy.check();
    if (head != nullptr) *head = copy.audit().head();
    return problems.empty() ? "" : problems.front();
}

/// Whoever comes first to a store without accounts becomes administrator: not where there were
/// some.
void need_accounts(StoreContext& context) {
    const StoreUrl& url = context.connection.url();
    if (!context.connection.is_sqlite() || url.path == ":memory:") return;
    if (!context.options.known && !std::filesystem::exists(mark_of_store(url.path))) return;
    if (!any_account(context.connection))
        context.connection.fail(StoreError::Kind::kMissing,
                                "the store that was here had accounts, and this one has none; "
                                "restore a backup with `placodectl restore FILE`, or begin anew "
                                "with `placodectl user add LOGIN --begin-anew`");
}

}  // namespace

Store::Store(std::unique_ptr<StoreContext> context)
    : context_(std::move(context)),
      accounts_(*context_),
      attempts_(*context_),
      norms_(*context_),
      groups_(*context_),
      courses_(*context_),
      reviews_(*context_),
      definitions_(*context_),
      studies_(*context_),
      records_(*context_),
      audit_(*context_) {}

Store::~Store() = default;

void Store::act_as(const std::string& actor) {
    context_->connection.begin_operation("name the program in");
    if (context_->actor.kind != Actor::Kind::kProgram) context_->refuse(Action::kActAs);
    context_->actor.name = context_->kept_name(actor);
    // A program that works in the name of who has signed in in it may on a server what they may.
    const int64_t account = account_of(context_->connection, login_key(actor));
    if (account != 0) context_->server.resume(account);
}

void Store::act_for(int64_t account_id) {
    context_->connection.begin_operation("act for an account in");
    const Actor& actor = context_->actor;
    if (actor.kind != Actor::Kind::kProgram && !context_->is_self(account_id))
        context_->refuse(Action::kActAs);
    context_->become(account_id);
    context_->server.resume(account_id);
}

void Store::sign_out() {
    context_->actor = {"unknown", Actor::Kind::kNobody, 0};
    context_->server.leave();
}

std::string Store::url() const { return context_->connection.url().shown; }

std::vector<std::string> Store::role_problems() {
    context_->connection.begin_operation("check");
    context_->need(Action::kBackup);
    return station_role_problems(context_->connection);
}

void Store::give_station_role() {
    context_->connection.begin_operation("give stations their rights in");
    context_->need(Action::kActAs);
    db::give_station_role(context_->connection);
}

void Store::backup(const std::string& path) {
    Connection& connection = context_->connection;
    connection.begin_operation("back up");
    context_->need(Action::kBackup);
    if (!connection.is_sqlite()) need_owner_of_tables(*context_);
    for (const std::string& file : {path, head_file_of(path)})
        if (std::filesystem::exists(file))
            connection.fail(
                StoreError::Kind::kConflict,
                Said::that("%1 exists and is not overwritten; give another name").with(file));
    // Before the trail says that there is a copy, and before a server's store is read in whole.
    need_room_for_copy(*context_, path);
    if (!connection.is_sqlite())
        if (const auto problems = check(); !problems.empty())
            connection.fail(
                StoreError::Kind::kDamaged,
                "it does not pass its check (" + problems.front() + "), and no copy was made");
    connection.begin_operation("back up");
    // First, so that an erasure knows of it whenever this is killed.
    UnitOfWork work(connection);
    // Whole, because an erasure begins in another folder.
    context_->append_audit("store.backup", std::filesystem::absolute(path).string(), "");
    work.commit();
    TrailHead head;
    if (connection.is_sqlite()) {
        keep_checked_copy(*context_, path, [this, &head](const std::string& copy) {
            return first_problem(copy, context_->options, &head);
        });
    } else {
        head = dump_store(*context_, path);
        context_->sign_head(head);
    }
    // A computer that cannot keep a key signs nothing.
    if (head.station.empty()) return;
    try {
        write_trail_head(head, head_file_of(path));
    } catch (...) {
        // Said to have failed, so it is not there: the same command may be given again.
        forget_sqlite_file(path);
        forget_sqlite_file(head_file_of(path));
        throw;
    }
}

std::unique_ptr<Store> open_store(const std::string& url, const StoreOptions& options) {
    assert(QCoreApplication::instance() != nullptr);
    const StoreUrl parsed = parse_store_url(url);
    if (parsed.engine == Engine::kSqlite) {
        if (options.begin_anew)
            std::filesystem::remove(mark_of_store(parsed.path));
        else
            need_known_store(parsed.path, options.known, "open");
        make_store_file(parsed,
                        options.migrations.empty() ? embedded_migrations() : options.migrations,
                        "open");
        prepare_sqlite_file(parsed.path, "open");
    }
    auto context = std::make_unique<StoreContext>(parsed, options);
    bring_up_to_date(*context);
    if (!options.begin_anew) need_accounts(*context);
    return std::make_unique<Store>(std::move(context));
}

bool store_was_here(const std::string& url) {
    const StoreUrl parsed = parse_store_url(url);
    return parsed.engine == Engine::kSqlite && std::filesystem::exists(mark_of_store(parsed.path));
}

std::string default_store_url() {
    return "sqlite:" +
           QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() +
           "/placode/placode.db";
}

}  // namespace placode::db

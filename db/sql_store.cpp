// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Opening, audit, health and backup of a store.

#include "db/sql_store.h"

#include <QDateTime>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <cassert>
#include <filesystem>

#include "db/packing.h"
#include "db/schema.h"
#include "db/sqlite_file.h"

namespace placode::db {
namespace {

std::string chain_link(const std::string& previous, const AuditRecord& row) {
    // Unit separators, so that no two different rows give the same text.
    std::string text = previous;
    for (const std::string* part : {&row.at_utc, &row.actor, &row.action, &row.object, &row.detail})
        text += '\x1f' + *part;
    return checksum_hex(text);
}

AuditRecord read_audit(const Statement& row) {
    return {row.integer("id"),  row.text("at_utc"), row.text("actor"),
            row.text("action"), row.text("object"), row.text("detail")};
}

// Two programs may update a store within one millisecond, so the name also says which.
std::string file_stamp() {
    return QDateTime::currentDateTimeUtc().toString("yyyyMMdd'T'HHmmsszzz'Z'").toStdString() + "-" +
           QUuid::createUuid().toString(QUuid::WithoutBraces).left(8).toStdString();
}

}  // namespace

SqlStore::SqlStore(const StoreUrl& url, StoreOptions options)
    : connection_(url), options_(std::move(options)) {
    migrations_ = options_.migrations.empty() ? embedded_migrations() : options_.migrations;
    connection_.begin_operation("open");
    if (connection_.is_sqlite()) claim_sqlite_file(connection_);
    migrate(connection_, migrations_, [this] {
        if (!connection_.is_sqlite() || connection_.url().path == ":memory:") return;
        const std::string problem = sqlite_integrity_problem(connection_);
        if (!problem.empty())
            connection_.fail(StoreError::Kind::kDamaged,
                             "not migrated, because it is damaged (" + problem +
                                 "); restore a backup with `placodectl restore FILE`");
        copy_sqlite_store(connection_, connection_.url().path + ".before-update-" + file_stamp());
    });
}

int64_t SqlStore::now_ms() const {
    return options_.now_ms ? options_.now_ms() : QDateTime::currentMSecsSinceEpoch();
}

void SqlStore::append_audit(const std::string& actor, const std::string& action,
                            const std::string& object, const std::string& detail) {
    connection_.lock_table("audit");
    std::string previous;
    Statement last(connection_, "SELECT chain FROM audit ORDER BY id DESC LIMIT 1");
    last.run();
    if (last.next()) previous = last.text(0);
    const AuditRecord row{0, utc_now(), actor, action, object, detail};
    Statement(connection_,
              "INSERT INTO audit (at_utc, actor, action, object, detail, chain) VALUES (?, ?, ?, "
              "?, ?, ?)")
        .run(row.at_utc, row.actor, row.action, row.object, row.detail, chain_link(previous, row));
}

void SqlStore::audit(const std::string& actor, const std::string& action, const std::string& object,
                     const std::string& detail) {
    connection_.begin_operation("write the audit trail of");
    UnitOfWork work(connection_);
    append_audit(actor, action, object, detail);
    work.commit();
}

std::vector<AuditRecord> SqlStore::audit_trail(int limit) {
    connection_.begin_operation("read the audit trail of");
    Statement query(connection_,
                    "SELECT id, at_utc, actor, action, object, detail FROM audit ORDER BY id DESC "
                    "LIMIT ?");
    query.run(limit);
    std::vector<AuditRecord> trail;
    while (query.next()) trail.push_back(read_audit(query));
    return trail;
}

void SqlStore::check_audit_chain(std::vector<std::string>& problems) {
    Statement query(connection_,
                    "SELECT id, at_utc, actor, action, object, detail, chain FROM audit ORDER BY "
                    "id");
    query.run();
    std::string previous;
    while (query.next()) {
        const AuditRecord row = read_audit(query);
        const std::string chain = query.text("chain");
        if (chain != chain_link(previous, row)) {
            problems.push_back("audit: entry " + std::to_string(row.id) +
                               " or the one before it was changed or removed");
            return;
        }
        previous = chain;
    }
}

void SqlStore::check_recordings(std::vector<std::string>& problems) {
    std::vector<int64_t> ids;
    Statement list(connection_, "SELECT attempt_id FROM recordings ORDER BY attempt_id");
    list.run();
    while (list.next()) ids.push_back(list.integer(0));
    for (const int64_t id : ids) {
        Statement query(connection_,
                        "SELECT size_bytes, checksum, content FROM recordings WHERE attempt_id = "
                        "?");
        query.run(id);
        if (!query.next()) continue;
        try {
            const QByteArray content = query.bytes("content");
            const Bytes file = decompress(std::as_bytes(std::span(content.data(), content.size())),
                                          static_cast<size_t>(query.integer("size_bytes")));
            if (checksum_hex(file) == query.text("checksum")) continue;
        } catch (const StoreError&) {
            // Reported below, like a wrong checksum.
        }
        problems.push_back("recordings: the recording of attempt " + std::to_string(id) +
                           " is damaged");
    }
}

std::vector<std::string> SqlStore::check() {
    connection_.begin_operation("check");
    std::vector<std::string> problems;
    if (connection_.is_sqlite()) {
        const std::string problem = sqlite_integrity_problem(connection_);
        if (!problem.empty()) problems.push_back("file: " + problem);
        Statement keys(connection_, "PRAGMA foreign_key_check");
        keys.run();
        if (keys.next())
            problems.push_back("references: a row of " + keys.text("table") +
                               " refers to a missing " + keys.text("parent"));
    }
    try {
        check_audit_chain(problems);
        check_recordings(problems);
    } catch (const StoreError& error) {
        problems.emplace_back(error.what());
    }
    return problems;
}

void SqlStore::backup(const std::string& path) {
    connection_.begin_operation("back up");
    if (!connection_.is_sqlite())
        connection_.fail(StoreError::Kind::kRefused,
                         "a PostgreSQL store is backed up on its server, with pg_dump");
    const std::string part = path + ".part";
    if (std::filesystem::exists(path))
        connection_.fail(StoreError::Kind::kConflict,
                         path + " exists and is not overwritten; give another name");
    std::filesystem::remove(part);
    copy_sqlite_store(connection_, part);
    std::filesystem::rename(part, path);
    UnitOfWork work(connection_);
    append_audit(actor_, "store.backup", path, "");
    work.commit();
}

std::unique_ptr<Store> open_store(const std::string& url, const StoreOptions& options) {
    assert(QCoreApplication::instance() != nullptr);
    const StoreUrl parsed = parse_store_url(url);
    if (parsed.engine == Engine::kSqlite) prepare_sqlite_file(parsed.path, "open");
    return std::make_unique<SqlStore>(parsed, options);
}

std::string default_store_url() {
    return "sqlite:" +
           QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() +
           "/placode/placode.db";
}

}  // namespace placode::db

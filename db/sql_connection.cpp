// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/sql_connection.h"

#include <sqlite3.h>
#include <sys/statvfs.h>

#include <QDateTime>
#include <QSqlDriver>
#include <QSqlField>
#include <QSqlRecord>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "db/raw_sqlite.h"
#include "db/statement_count.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

struct Diagnosis {
    Kind kind;
    const char* way_out;
};

// The low byte of SQLite's extended code names the family.
Diagnosis diagnose_sqlite(int code) {
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {Kind::kLocked,
                    "another program holds the store; close it, or wait and try again"};
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return {Kind::kDamaged,
                    "the file is damaged; leave it as it is and restore a backup with `placodectl "
                    "restore FILE`"};
        case SQLITE_READONLY:
        case SQLITE_CANTOPEN:
        case SQLITE_PERM:
        case SQLITE_AUTH:
            return {Kind::kUnavailable, "check that folder and file may be written by you"};
        case SQLITE_FULL:
            return {Kind::kUnavailable, "the disk is full; make room and try again"};
        case SQLITE_IOERR:
            return {Kind::kUnavailable, "the disk answers with errors; check it"};
        case SQLITE_CONSTRAINT:
            if (code == SQLITE_CONSTRAINT_TRIGGER) return {Kind::kRefused, "nothing was changed"};
            return {Kind::kConflict, "nothing was changed"};
        default:
            return {Kind::kOther, "nothing was changed"};
    }
}

/// On a full disk SQLite may answer as on a broken one (it cannot make the log's index), and never
/// says where: what it is, and the folder.
std::string words_for_the_disk(const std::string& path, bool said_full) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    constexpr uint64_t kNoRoom = uint64_t{256} << 10;
    struct statvfs disk {};
    const bool full = said_full || (::statvfs(folder.c_str(), &disk) == 0 &&
                                    uint64_t{disk.f_bavail} * disk.f_frsize < kNoRoom);
    return (full ? "the disk is full; make room and try again"
                 : "the disk answers with errors; check it") +
           (" (folder " + folder.string() + ")");
}

// SQLSTATE classes: PostgreSQL manual, appendix A.
Diagnosis diagnose_postgresql(const std::string& state, QSqlError::ErrorType type) {
    const std::string family = state.substr(0, 2);
    if (family == "23") return {Kind::kConflict, "nothing was changed"};
    if (state == "P0001") return {Kind::kRefused, "nothing was changed"};
    if (state == "55P03" || family == "40")
        return {Kind::kLocked, "another program holds the data; wait and try again"};
    if (family == "08" || family == "57" || family == "28" || family == "53" || state.empty() ||
        type == QSqlError::ConnectionError)
        return {Kind::kUnavailable,
                "check that the server runs and that host, port, name, user and password are "
                "right; a server elsewhere has to prove who it is (?sslrootcert=FILE or "
                "~/.postgresql/root.crt), unless the address says another ?sslmode"};
    return {Kind::kOther, "nothing was changed"};
}

std::string first_line(const QString& text) {
    return text.section('\n', 0, 0).trimmed().toStdString();
}

}  // namespace

Connection::Connection(const StoreUrl& url) : url_(url) {
    static std::atomic<int> counter{0};
    name_ = QStringLiteral("placode-%1").arg(++counter);
    const QString driver = is_sqlite() ? QStringLiteral("QSQLITE") : QStringLiteral("QPSQL");
    database_ = QSqlDatabase::addDatabase(driver, name_);
    if (!database_.isValid()) {
        database_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(name_);
        fail(Kind::kUnavailable, "Qt's database driver " + driver.toStdString() +
                                     " is missing; install libqt6sql6-" +
                                     (is_sqlite() ? "sqlite" : "psql"));
    }
    try {
        open();
    } catch (...) {
        database_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(name_);
        throw;
    }
}

Connection::~Connection() {
    // The last connection to a SQLite file that closes also folds the write-ahead log back in.
    database_.close();
    database_ = QSqlDatabase();
    QSqlDatabase::removeDatabase(name_);
}

void Connection::open() {
    if (is_sqlite()) {
        database_.setDatabaseName(QString::fromStdString(url_.path));
        database_.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(url_.timeout_ms));
    } else {
        database_.setHostName(QString::fromStdString(url_.host));
        database_.setPort(url_.port);
        database_.setUserName(QString::fromStdString(url_.user));
        database_.setPassword(QString::fromStdString(url_.password));
        database_.setDatabaseName(QString::fromStdString(url_.name));
        database_.setConnectOptions(QString::fromStdString(connect_options(url_)));
    }
    if (!database_.open()) fail(database_.lastError());
    if (is_sqlite()) {
        distrust_schema(sqlite_handle());  // Before the first statement reads it.
        execute("PRAGMA foreign_keys = ON");
        execute("PRAGMA synchronous = FULL");
        execute("PRAGMA secure_delete = ON");  // What is erased leaves no bytes in free pages.
    } else {
        execute("SET lock_timeout = " + std::to_string(url_.timeout_ms));
        execute("SET client_min_messages = warning");
    }
}

void Connection::begin_operation(const std::string& operation) {
    operation_ = operation;
    if (database_.isOpen()) return;
    open();
    if (reopened_) reopened_();
}

bool Connection::hides_passwords() {
    if (is_sqlite()) return false;
    if (!hides_passwords_) {
        Statement query(*this,
                        "SELECT CASE WHEN has_column_privilege('accounts', 'password_hash', "
                        "'SELECT') THEN 0 ELSE 1 END");
        hides_passwords_ = query.run().next() && query.integer(0) != 0;
    }
    return *hides_passwords_;
}

void Connection::begin_transaction() {
    // IMMEDIATE: take the write lock now and wait for it. A deferred transaction that reads first
    // is refused at its first write when another one has written meanwhile.
    execute(is_sqlite() ? "BEGIN IMMEDIATE" : "BEGIN");
    in_transaction_ = true;
    if (begun_) begun_();
}

void Connection::commit_transaction() {
    if (committing_) committing_();
    execute("COMMIT");
    in_transaction_ = false;
    if (committed_) committed_();
}

void Connection::watch_transactions(std::function<void()> begun, std::function<void()> committing,
                                    std::function<void()> committed) {
    begun_ = std::move(begun);
    committing_ = std::move(committing);
    committed_ = std::move(committed);
}

void Connection::roll_back() noexcept {
    if (!in_transaction_) return;
    in_transaction_ = false;
    QSqlQuery query(database_);
    query.exec(QStringLiteral("ROLLBACK"));  // Fails only if there is nothing left to roll back.
}

void Connection::execute(const std::string& sql) {
    QSqlQuery query(database_);
    ++statements_sent();
    if (!query.exec(QString::fromStdString(sql))) fail(query.lastError());
}

void Connection::lock_table(const std::string& table, int patience) {
    if (is_sqlite()) return;
    // Not LOCK TABLE: a station's log-in has no right to it where it may only add rows.
    const std::string lock = "pg_advisory_xact_lock(1347371844, hashtext('" + table + "'))";
    const auto waiting = [this](int64_t times) {
        const int64_t most = std::min<int64_t>(times * url_.timeout_ms, INT32_MAX);
        return "set_config('lock_timeout', '" + std::to_string(most) + "', true)";
    };
    // In one round trip: the columns are computed from left to right.
    execute("SELECT " +
            (patience == 1 ? lock : waiting(patience) + ", " + lock + ", " + waiting(1)));
}

sqlite3* Connection::sqlite_handle() const {
    if (!is_sqlite()) return nullptr;
    const QVariant handle = database_.driver()->handle();
    return *static_cast<sqlite3* const*>(handle.data());
}

void Connection::fail(StoreError::Kind kind, const std::string& problem) const {
    throw StoreError(kind, operation_ + " " + url_.shown + ": " + problem);
}

void Connection::fail(StoreError::Kind kind, const Said& said) const {
    throw StoreError(kind, operation_ + " " + url_.shown + ": ", said);
}

void Connection::explain_refusals(std::function<std::optional<Said>()> meaning) {
    meaning_of_refusal_ = std::move(meaning);
}

void Connection::fail(const QSqlError& error) {
    const QString code = error.nativeErrorCode();
    const Diagnosis diagnosis = is_sqlite() ? diagnose_sqlite(code.toInt())
                                            : diagnose_postgresql(code.toStdString(), error.type());
    std::string said = first_line(error.databaseText());
    if (said.empty()) said = first_line(error.driverText());
    // "ERROR:  the audit trail is append-only", in the server's language.
    constexpr size_t kLongestWord = 16;
    if (const size_t word = said.find(":  "); !is_sqlite() && word < kLongestWord)
        said.erase(0, word + 3);
    // PostgreSQL does nothing more in a transaction that failed, not even forget a statement.
    if (!is_sqlite()) roll_back();
    // A server connection that broke is opened again by the next operation.
    if (!is_sqlite() && diagnosis.kind == Kind::kUnavailable) database_.close();
    const int family = is_sqlite() ? code.toInt() & 0xff : 0;
    const bool disk = (family == SQLITE_IOERR || family == SQLITE_FULL) && url_.path != ":memory:";
    const std::string problem =
        said + "; " +
        (disk ? words_for_the_disk(url_.path, family == SQLITE_FULL) : diagnosis.way_out);
    if (diagnosis.kind != Kind::kRefused) fail(diagnosis.kind, problem);
    // A trigger has nothing but text; whoever knows what it stands for says that.
    const auto meaning = meaning_of_refusal_ ? meaning_of_refusal_() : std::nullopt;
    fail(diagnosis.kind,
         meaning && meaning->english() == problem ? *meaning : Said::as_is(problem));
}

Statement::Statement(Connection& connection, const std::string& sql)
    : connection_(connection), query_(connection.handle()) {
    query_.setForwardOnly(true);
    // A failed prepare would otherwise show up later as "Parameter count mismatch".
    if (!query_.prepare(QString::fromStdString(sql))) connection_.fail(query_.lastError());
}

void Statement::execute() {
    ++statements_sent();
    if (!query_.exec()) connection_.fail(query_.lastError());
}

Statement& Statement::run_list(const std::vector<QVariant>& values) {
    for (size_t i = 0; i < values.size(); ++i) query_.bindValue(static_cast<int>(i), values[i]);
    execute();
    return *this;
}

bool Statement::next() {
    if (query_.next()) return true;
    // Else a disk or a server that fails half-way would look like the end of a list.
    if (query_.lastError().isValid()) connection_.fail(query_.lastError());
    return false;
}

int64_t Statement::returned_id() {
    if (!next()) connection_.fail(Kind::kOther, "the engine gave no id");
    const int64_t id = integer(0);
    query_.finish();
    return id;
}

const std::vector<std::string>& Statement::names() const {
    if (names_.empty()) {
        const QSqlRecord record = query_.record();
        for (int i = 0; i < record.count(); ++i)
            names_.push_back(record.fieldName(i).toStdString());
    }
    return names_;
}

int Statement::columns() const { return static_cast<int>(names().size()); }

int Statement::search(std::string_view name) const {
    const std::vector<std::string>& all = names();
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end())
        throw std::logic_error("no column \"" + std::string(name) +
                               "\" in: " + query_.lastQuery().toStdString());
    next_ = static_cast<size_t>(found - all.begin());
    return static_cast<int>(next_++);
}

int64_t Statement::integer(int column) const { return query_.value(column).toLongLong(); }

double Statement::real(int column) const {
    const QVariant value = query_.value(column);
    return value.isNull() ? std::numeric_limits<double>::quiet_NaN() : value.toDouble();
}

std::string Statement::text(int column) const {
    return query_.value(column).toString().toStdString();
}

QByteArray Statement::bytes(int column) const { return query_.value(column).toByteArray(); }

QVariant Statement::to_variant(const std::string& text) {
    // An empty string is not NULL.
    return text.empty() ? QVariant(QStringLiteral("")) : QVariant(QString::fromStdString(text));
}

QVariant Statement::to_variant(double number) {
    return std::isfinite(number) ? QVariant(number) : QVariant(QMetaType(QMetaType::Double));
}

std::string utc_now() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
}

}  // namespace placode::db

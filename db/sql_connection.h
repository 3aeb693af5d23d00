// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Qt Sql with exceptions: a connection, a statement, a transaction. Only db/ includes this.

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "db/said.h"
#include "db/store_error.h"
#include "db/store_url.h"

struct sqlite3;

namespace placode::db {

/// One connection of one thread, under a name of its own in Qt's register.
class Connection {
 public:
    explicit Connection(const StoreUrl& url);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Says what is being done, for messages, and opens again what a server had dropped.
    void begin_operation(const std::string& operation);
    void begin_transaction();
    void commit_transaction();
    void roll_back() noexcept;  ///< Does nothing outside a transaction.
    /// Called when a transaction began, before it is committed, within it, and when it was.
    void watch_transactions(std::function<void()> begun, std::function<void()> committing,
                            std::function<void()> committed = {});
    /// Called when begin_operation() has opened a connection that a server had dropped.
    void after_reopening(std::function<void()> reopened) { reopened_ = std::move(reopened); }
    /// Whether this log-in may not read hashes of passwords: the server compares them itself
    /// (db/server_session.h). Asked once; the tables have to be there.
    [[nodiscard]] bool hides_passwords();
    void execute(const std::string& sql);  ///< One statement, no parameters, no result.
    /// Keeps others that ask for the same away from a table until the transaction ends. SQLite has
    /// done so already.
    /// @param patience how many times as long it waits as for a row
    void lock_table(const std::string& table, int patience = 1);
    [[nodiscard]] QSqlDatabase& handle() { return database_; }
    [[nodiscard]] sqlite3* sqlite_handle() const;  ///< nullptr on PostgreSQL.
    [[nodiscard]] const StoreUrl& url() const { return url_; }
    [[nodiscard]] bool is_sqlite() const { return url_.engine == Engine::kSqlite; }

    [[noreturn]] void fail(StoreError::Kind kind, const std::string& problem) const;
    [[noreturn]] void fail(StoreError::Kind kind, const Said& said) const;
    [[noreturn]] void fail(const QSqlError& error);
    /// Asked where a trigger refused a change: what that means to people, if it is known.
    void explain_refusals(std::function<std::optional<Said>()> meaning);

 private:
    void open();

    StoreUrl url_;
    QString name_;
    QSqlDatabase database_;
    std::string operation_ = "open";
    bool in_transaction_ = false;
    std::function<void()> begun_, committing_, committed_, reopened_;
    std::optional<bool> hides_passwords_;
    std::function<std::optional<Said>()> meaning_of_refusal_;
};

/// A reference: 0 is bound as NULL.
struct OrNull {
    int64_t id = 0;
};

/// A prepared statement with `?` places.
class Statement {
 public:
    Statement(Connection& connection, const std::string& sql);

    /// Binds all values in order and runs.
    template <class... Values>
    Statement& run(const Values&... values) {
        int place = 0;
        (query_.bindValue(place++, to_variant(values)), ...);
        execute();
        return *this;
    }
    /// The same with values in a list.
    Statement& run_list(const std::vector<QVariant>& values);
    /// The next row; false: there are no more. Throws StoreError when the rest cannot be read.
    [[nodiscard]] bool next();
    /// The id that `INSERT ... RETURNING id` answers. Ends the statement: an open one would keep
    /// the transaction from committing.
    [[nodiscard]] int64_t returned_id();
    /// A value of the row, by column from 0: where the question stands beside, with a column or
    /// two.
    [[nodiscard]] int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;  ///< NULL = not a number.
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] QByteArray bytes(int column) const;
    /// As the engine gives it: for rows that are passed on whatever they hold.
    [[nodiscard]] QVariant value(int column) const { return query_.value(column); }
    /// The same by name: `AS name` in the question, or the column's own. Throws std::logic_error
    /// for a name that the question does not have.
    [[nodiscard]] int64_t integer(std::string_view name) const { return integer(place_of(name)); }
    [[nodiscard]] double real(std::string_view name) const { return real(place_of(name)); }
    [[nodiscard]] std::string text(std::string_view name) const { return text(place_of(name)); }
    [[nodiscard]] QByteArray bytes(std::string_view name) const { return bytes(place_of(name)); }
    [[nodiscard]] int columns() const;  ///< Of the answer.
    [[nodiscard]] int64_t affected() const { return query_.numRowsAffected(); }

 private:
    friend class ManyRows;  // Binds as run() does.

    void execute();
    /// Names of the answer's columns, read once: they stay the same however often it is run.
    [[nodiscard]] const std::vector<std::string>& names() const;
    /// Readers ask in the order of the columns, for 100,000 rows: the next one is the likely one.
    [[nodiscard]] int place_of(std::string_view name) const {
        if (next_ < names_.size() && names_[next_] == name) return static_cast<int>(next_++);
        return search(name);
    }
    [[nodiscard]] int search(std::string_view name) const;
    static QVariant to_variant(const std::string& text);
    static QVariant to_variant(const char* text) { return to_variant(std::string(text)); }
    static QVariant to_variant(int64_t number) { return QVariant(qlonglong(number)); }
    static QVariant to_variant(OrNull reference) {
        return reference.id == 0 ? QVariant(QMetaType(QMetaType::LongLong))
                                 : to_variant(reference.id);
    }
    static QVariant to_variant(int number) { return QVariant(number); }
    static QVariant to_variant(bool truth) { return QVariant(truth ? 1 : 0); }
    static QVariant to_variant(double number);  ///< Not finite = NULL.
    static QVariant to_variant(const QByteArray& bytes) { return QVariant(bytes); }

    Connection& connection_;
    QSqlQuery query_;
    mutable std::vector<std::string> names_;
    mutable size_t next_ = 0;  ///< The place after the one that was asked for last.
};

/// A write transaction: all or nothing. Rolls back unless commit() was reached.
class UnitOfWork {
 public:
    explicit UnitOfWork(Connection& connection) : connection_(connection) {
        connection_.begin_transaction();
    }
    ~UnitOfWork() { connection_.roll_back(); }
    UnitOfWork(const UnitOfWork&) = delete;
    UnitOfWork& operator=(const UnitOfWork&) = delete;
    void commit() { connection_.commit_transaction(); }

 private:
    Connection& connection_;
};

/// Now, ISO 8601 with milliseconds, UTC.
[[nodiscard]] std::string utc_now();

}  // namespace placode::db

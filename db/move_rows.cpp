// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/move_rows.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace placode::db {
namespace {

using Row = std::vector<QVariant>;

constexpr size_t kRowsOfAnInsert = 64;         ///< A server far away takes as long for one.
constexpr int64_t kRowsOfATransaction = 2048;  ///< What a stop may cost.
constexpr int64_t kBytesOfATransaction = int64_t{8} << 20;

/// Texts by their bytes, whatever language a server sorts in.
std::string key_word(const Connection& connection, const StoreTable& table, size_t i) {
    return table.key[i] + (table.key_is_text[i] && !connection.is_sqlite() ? " COLLATE \"C\"" : "");
}

std::string key_words(const Connection& connection, const StoreTable& table, const char* behind) {
    std::vector<std::string> words;
    for (size_t i = 0; i < table.key.size(); ++i)
        words.push_back(key_word(connection, table, i) + behind);
    return listed(words);
}

std::string places(size_t count) {
    return "(" + listed(std::vector<std::string>(count, "?")) + ")";
}

/// @param behind the key of a row; empty = from the beginning.
std::string rows_sql(const Connection& connection, const StoreTable& table, const Row& behind) {
    std::string sql = "SELECT " + listed(table.columns) + " FROM " + table.name;
    if (!behind.empty())
        sql += " WHERE (" + key_words(connection, table, "") + ") > " + places(behind.size());
    return sql + " ORDER BY " + key_words(connection, table, "");
}

Row read_row(const Statement& query, size_t columns) {
    Row row;
    row.reserve(columns);
    for (size_t i = 0; i < columns; ++i) row.push_back(query.value(static_cast<int>(i)));
    return row;
}

/// Of the last row that is there; empty = none is.
Row last_key(Connection& connection, const StoreTable& table) {
    Statement query(connection, "SELECT " + listed(table.key) + " FROM " + table.name +
                                    " ORDER BY " + key_words(connection, table, " DESC") +
                                    " LIMIT 1");
    return query.run().next() ? read_row(query, table.key.size()) : Row();
}

class Inserter {
 public:
    Inserter(Connection& to, const StoreTable& table)
        : to_(to), table_(table), many_(table.has_bytes ? 1 : kRowsOfAnInsert) {}

    void add(Row row) {
        for (QVariant& value : row) {
            if (value.typeId() == QMetaType::QByteArray) bytes_ += value.toByteArray().size();
            values_.push_back(std::move(value));
        }
        ++rows_;
        if (values_.size() == many_ * table_.columns.size()) insert();
    }
    [[nodiscard]] bool full() const {
        return rows_ >= kRowsOfATransaction || bytes_ >= kBytesOfATransaction;
    }
    /// What was added since the last time; the caller commits.
    int64_t finish() {
        if (!values_.empty()) insert();
        bytes_ = 0;
        return std::exchange(rows_, 0);
    }

 private:
    void insert() {
        const size_t count = values_.size() / table_.columns.size();
        if (count < many_) {
            Statement(to_, sql(count)).run_list(values_);
        } else {
            if (!full_) full_.emplace(to_, sql(count));
            full_->run_list(values_);
        }
        values_.clear();
    }
    [[nodiscard]] std::string sql(size_t rows) const {
        return "INSERT INTO " + table_.name + " (" + listed(table_.columns) + ") VALUES " +
               listed(std::vector<std::string>(rows, places(table_.columns.size())));
    }

    Connection& to_;
    const StoreTable& table_;
    size_t many_;
    std::optional<Statement> full_;
    std::vector<QVariant> values_;
    int64_t rows_ = 0, bytes_ = 0;
};

/// An engine gives a number back as the type of its column, never rounded.
bool same_value(const QVariant& a, const QVariant& b) {
    if (a.isNull() || b.isNull()) return a.isNull() == b.isNull();
    const int type = a.typeId();
    if (type == QMetaType::Double || type == QMetaType::QString || type == QMetaType::QByteArray) {
        if (type != b.typeId()) return false;
        if (type != QMetaType::Double) return a == b;
        return std::bit_cast<uint64_t>(a.toDouble()) == std::bit_cast<uint64_t>(b.toDouble());
    }
    // Whole numbers come as this or that type, by how the driver reads the column.
    bool whole = false, also = false;
    return a.toLongLong(&whole) == b.toLongLong(&also) && whole && also &&
           b.typeId() != QMetaType::Double && b.typeId() != QMetaType::QString;
}

class RowStream {
 public:
    RowStream(Connection& connection, const StoreTable& table)
        : table_(table), query_(connection, rows_sql(connection, table, {})) {
        for (const std::string& name : table.key) {
            const auto at = std::find(table.columns.begin(), table.columns.end(), name);
            key_.push_back(static_cast<size_t>(at - table.columns.begin()));
        }
        query_.run();
        advance();
    }
    void advance() {
        more_ = query_.next();
        row_ = more_ ? read_row(query_, table_.columns.size()) : Row();
    }
    [[nodiscard]] bool more() const { return more_; }
    [[nodiscard]] const Row& row() const { return row_; }
    [[nodiscard]] std::string name() const {
        std::string text = table_.name;
        for (const size_t i : key_)
            text += ", " + table_.columns[i] + " " + row_[i].toString().toStdString();
        return text;
    }
    /// Whether this row stands before the other's: the order of both streams.
    [[nodiscard]] bool before(const RowStream& other) const {
        for (const size_t i : key_) {
            if (row_[i].typeId() == QMetaType::QString) {
                const QByteArray mine = row_[i].toByteArray(), others = other.row_[i].toByteArray();
                if (mine != others) return mine < others;
            } else if (row_[i].toLongLong() != other.row_[i].toLongLong()) {
                return row_[i].toLongLong() < other.row_[i].toLongLong();
            }
        }
        return false;
    }

 private:
    const StoreTable& table_;
    Statement query_;
    std::vector<size_t> key_;
    Row row_;
    bool more_ = false;
};

}  // namespace

void copy_rows(Connection& from, Connection& to, const StoreTable& table, const RowsDone& done) {
    const Row behind = last_key(to, table);
    Statement query(from, rows_sql(from, table, behind));
    query.run_list(behind);
    const auto read = [&] {
        return query.next() ? std::optional(read_row(query, table.columns.size())) : std::nullopt;
    };
    Inserter inserter(to, table);
    for (auto row = read(); row;) {
        UnitOfWork work(to);
        for (; row && !inserter.full(); row = read()) inserter.add(std::move(*row));
        const int64_t rows = inserter.finish();
        work.commit();
        done(rows);
    }
}

std::string first_difference(Connection& from, Connection& to, const StoreTable& table,
                             const RowsDone& done) {
    RowStream here(from, table), there(to, table);
    int64_t rows = 0;
    for (; here.more() && there.more(); here.advance(), there.advance()) {
        if (here.before(there)) return here.name() + " is missing";
        if (there.before(here)) return there.name() + " was added";
        for (size_t i = 0; i < table.columns.size(); ++i)
            if (!same_value(here.row()[i], there.row()[i]))
                return here.name() + ": " + table.columns[i] + " differs";
        if (++rows % kRowsOfATransaction == 0 || table.has_bytes) done(std::exchange(rows, 0));
    }
    done(rows);
    if (here.more()) return here.name() + " is missing";
    if (there.more()) return there.name() + " was added";
    return {};
}

}  // namespace placode::db

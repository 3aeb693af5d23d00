// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows written by the hundred: each statement is a round trip to a server. Only db/*.cpp include
// this.

#include <optional>
#include <string>
#include <vector>

#include "db/sql_connection.h"

namespace placode::db {

/// Rows for one table, sent in blocks. What was added is there after finish() only.
class ManyRows {
 public:
    /// Twelve columns make 1,200 bound values; SQLite takes 32,766 in a statement, PostgreSQL
    /// 65,535.
    static constexpr size_t kRowsAtOnce = 100;

    /// @param into "table (column, ...)"
    ManyRows(Connection& connection, std::string into)
        : connection_(connection), into_(std::move(into)) {}

    /// A row: as many values at each call, bound as Statement::run() does.
    template <class... Values>
    void add(const Values&... values) {
        columns_ = sizeof...(Values);
        (values_.push_back(Statement::to_variant(values)), ...);
        if (values_.size() == kRowsAtOnce * columns_) send();
    }
    void finish() {
        if (!values_.empty()) send();
    }

 private:
    [[nodiscard]] std::string text_for(size_t rows) const {
        std::string row = "(?";
        for (size_t i = 1; i < columns_; ++i) row += ", ?";
        row += ')';
        std::string text = "INSERT INTO " + into_ + " VALUES " + row;
        for (size_t i = 1; i < rows; ++i) text += ", " + row;
        return text;
    }
    void send() {
        const size_t rows = values_.size() / columns_;
        if (rows == kRowsAtOnce) {
            if (!block_) block_.emplace(connection_, text_for(rows));
            block_->run_list(values_);
        } else {
            Statement(connection_, text_for(rows)).run_list(values_);
        }
        values_.clear();
    }

    Connection& connection_;
    std::string into_;
    size_t columns_ = 0;
    std::vector<QVariant> values_;
    std::optional<Statement> block_;  ///< A whole one is prepared once.
};

}  // namespace placode::db

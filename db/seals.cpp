// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/seals.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "db/packing.h"
#include "db/seal_kinds.h"
#include "db/sql_connection.h"
#include "db/station_guard.h"

namespace placode::db {
namespace {

using View = std::string_view;

const SealKind& kind_of(const std::string& name) {
    for (const SealKind& kind : seal_kinds())
        if (kind.name == name) return kind;
    throw std::logic_error("\"" + name + "\" is no kind of sealed object");
}

template <size_t N>
std::string listed(const std::array<View, N>& names) {
    std::string text;
    for (const View name : names)
        if (!name.empty()) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

/// Rows in an order that is the same everywhere: a server sorts texts by its own language, and a
/// seal has to fit also after the store was moved to another one.
std::string order_of(const SealPart& part, bool sqlite) {
    std::string text;
    for (const View name : part.order) {
        if (name.empty()) continue;
        text += (text.empty() ? "" : ", ") + std::string(name);
        // Of all that orders rows only these are texts.
        if (!sqlite && name.ends_with("item")) text += " COLLATE \"C\"";
    }
    return text;
}

size_t key_columns(const SealPart& part) {
    return static_cast<size_t>(
        std::count_if(part.key.begin(), part.key.end(), [](View each) { return !each.empty(); }));
}

/// Of rows that this log-in to a server may not read in whole the server makes the checksum itself
/// (db/station_guard_sql.cpp); nullptr: it may.
const char* checksum_function(Connection& connection, const SealPart& part) {
    const bool account = part.table == "accounts";
    if ((!account && part.table != "account_pins") || !connection.hides_passwords()) return nullptr;
    return account ? "placode_guard.seal_of_account" : "placode_guard.seal_of_pin";
}

std::string checksums_of(const char* function, const SealPart& part) {
    const std::string key(part.key.front()), table(part.table);
    return "SELECT " + key + ", " + function + "(" + key + ") FROM " + table + " ORDER BY " + key;
}

std::string rows_of(const SealPart& part, bool of_one, bool sqlite) {
    const std::string keys = listed(part.key), also = listed(part.order);
    const std::string order = order_of(part, sqlite);
    std::string sql = "SELECT " + keys + ", " + (also.empty() ? "" : also + ", ") +
                      std::string(part.columns) + " FROM " + std::string(part.table);
    if (of_one) {
        const bool has_where = part.table.find(" WHERE ") != View::npos;
        for (size_t i = 0; i < key_columns(part); ++i)
            sql += (i == 0 && !has_where ? " WHERE " : " AND ") + std::string(part.key[i]) + " = ?";
    }
    return sql + " ORDER BY " +
           (of_one && order.empty() ? keys
            : of_one                ? order
            : order.empty()         ? keys
                                    : keys + ", " + order);
}

void add_row(std::string& rows, const Statement& query, size_t first) {
    // PostgreSQL's driver makes "0" of a number that is not there, and SQLite's nothing.
    for (int i = static_cast<int>(first); i < query.columns(); ++i)
        add_text(rows, query.value(i).isNull() ? std::string() : query.text(i));
    rows += '\n';
}

/// What a part adds to the object's seal.
/// @param rows already their checksum where the server has made it
std::string part_text(size_t number, const std::string& rows, bool is_checksum) {
    return std::to_string(number) + " " + (is_checksum ? rows : checksum_hex(rows)) + "\n";
}

void add_part(Connection& connection, const SealKind& kind, size_t number,
              std::map<SealedObject, std::string>& texts, const std::function<void()>& pace) {
    const SealPart& part = kind.parts[number];
    const size_t keys = key_columns(part);
    const char* const summed = checksum_function(connection, part);
    Statement query(connection, summed != nullptr ? checksums_of(summed, part)
                                                  : rows_of(part, false, connection.is_sqlite()));
    query.run();
    SealedObject object{std::string(kind.name), {}};
    std::string rows;
    const auto finish = [&] {
        if (rows.empty()) return;
        // Rows of an object that is not sealed, or not there.
        if (number == 0)
            texts[object] = part_text(number, rows, summed != nullptr);
        else if (const auto found = texts.find(object); found != texts.end())
            found->second += part_text(number, rows, summed != nullptr);
        rows.clear();
    };
    std::vector<std::string> key(keys);
    while (query.next()) {
        if (pace) pace();
        for (size_t i = 0; i < keys; ++i) key[i] = query.text(static_cast<int>(i));
        if (key != object.key) {
            finish();
            object.key = key;
        }
        if (summed != nullptr)
            rows = query.text(1);
        else
            add_row(rows, query, keys);
    }
    finish();
}

}  // namespace

std::string SealedObject::name() const {
    std::string text = kind;
    for (const std::string& part : key) text += " " + part;
    return text;
}

std::string seal_of(Connection& connection, const SealedObject& object) {
    const SealKind& kind = kind_of(object.kind);
    std::string text;
    if (server_seals(kind.name) && connection.hides_passwords()) {
        Statement query(connection, "SELECT placode_guard.seal_parts(?, ?)");
        if (query.run(object.kind, int64_t{std::stoll(object.key.front())}).next())
            text = query.text(0);
        return text.empty() ? kNoObject : checksum_hex(text);
    }
    for (size_t number = 0; number < kind.parts.size(); ++number) {
        const SealPart& part = kind.parts[number];
        std::vector<QVariant> values;
        for (const std::string& key : object.key)
            values.emplace_back(kind.numeric ? QVariant(qlonglong{std::stoll(key)})
                                             : QVariant(QString::fromStdString(key)));
        Statement query(connection, rows_of(part, true, connection.is_sqlite()));
        query.run_list(values);
        std::string rows;
        while (query.next()) add_row(rows, query, key_columns(part));
        if (rows.empty() && number == 0) return kNoObject;
        if (!rows.empty()) text += part_text(number, rows, false);
    }
    return checksum_hex(text);
}

std::map<SealedObject, std::string> all_seals(Connection& connection,
                                              const std::function<void()>& pace) {
    std::map<SealedObject, std::string> seals;
    for (const SealKind& kind : seal_kinds()) {
        std::map<SealedObject, std::string> texts;
        for (size_t number = 0; number < kind.parts.size(); ++number)
            add_part(connection, kind, number, texts, pace);
        for (auto& [object, text] : texts) text = checksum_hex(text);
        seals.merge(texts);
    }
    return seals;
}

std::string seals_text(const SealChanges& changes) {
    std::string text;
    for (const auto& [object, change] : changes) {
        text += object.kind;
        for (const std::string& key : object.key) text += '\t' + key;
        text += '\t' + change.before + '\t' + change.after + '\n';
    }
    return text;
}

SealChanges seals_of_text(const std::string& text) {
    SealChanges changes;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> words;
        std::istringstream parts(line);
        for (std::string word; std::getline(parts, word, '\t');) words.push_back(word);
        if (words.size() < 4) continue;
        const SealedObject object{words.front(), {words.begin() + 1, words.end() - 2}};
        changes[object] = {words[words.size() - 2], words.back()};
    }
    return changes;
}

std::vector<SealedTable> sealed_tables() {
    std::vector<SealedTable> tables;
    const auto last_word = [](std::string text) {
        text = text.substr(text.find('.') + 1);
        return text.starts_with("CAST(") ? text.substr(5, text.find(' ') - 5) : text;
    };
    for (const SealKind& kind : seal_kinds())
        for (const SealPart& part : kind.parts) {
            SealedTable& table = tables.emplace_back();
            table.table = std::string(part.table.substr(0, part.table.find(' ')));
            std::istringstream columns(rows_of(part, false, true));
            std::string word;
            columns >> word;  // SELECT
            while (columns >> word && word != "FROM") {
                if (word.ends_with(',')) word.pop_back();
                if (word == "AS" || word == "TEXT)") continue;
                table.columns.push_back(last_word(word));
            }
        }
    return tables;
}

}  // namespace placode::db

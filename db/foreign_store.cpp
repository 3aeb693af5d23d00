// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/foreign_store.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>

#include "db/raw_sqlite.h"
#include "db/said.h"
#include "db/schema.h"
#include "db/sqlite_file.h"
#include "db/store_place.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// A row of sqlite_schema.
struct SchemaObject {
    std::string type, name, table, sql;
    [[nodiscard]] auto key() const { return std::tie(type, name, table, sql); }
    bool operator<(const SchemaObject& other) const { return key() < other.key(); }
};

constexpr const char* kReadSchema =
    "SELECT type, name, tbl_name, COALESCE(sql, '') FROM sqlite_schema";

Said not_ours(const std::string& object) {
    return Said::that(
               "it holds %1, which Placode did not make and which may be there to do harm; nothing "
               "was changed; use another copy of the store, or have whoever put it there take it "
               "out")
        .with(object);
}

// SQLite compares names without regard to the case of ASCII letters.
std::string lower(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

/// Everything that any number of migrations leaves in a file, as this SQLite writes it down.
class OwnSchema {
 public:
    explicit OwnSchema(const std::vector<EmbeddedSql>& migrations) {
        sqlite3* memory = nullptr;
        sqlite3_open(":memory:", &memory);
        const SqlitePointer owner(memory);
        run(memory, "BEGIN");
        run(memory, kCreateRegister);
        run(memory, kCreatePlaceTable);
        keep(memory);
        for (const EmbeddedSql& migration : migrations) {
            for (const std::string& statement : statements_of(migration, Engine::kSqlite))
                run(memory, statement.c_str());
            keep(memory);  // A store of an older program stops here.
        }
        // What SQLite's own ANALYZE makes, in every build of it.
        for (const auto& [name, columns] : {std::pair{"sqlite_stat1", "tbl,idx,stat"},
                                            {"sqlite_stat4", "tbl,idx,neq,nlt,ndlt,sample"}})
            objects_.insert(
                {"table", name, name, std::string("CREATE TABLE ") + name + "(" + columns + ")"});
    }

    [[nodiscard]] bool holds(const SchemaObject& object) const { return objects_.contains(object); }
    [[nodiscard]] bool names_table(const std::string& name) const {
        return tables_.contains(lower(name));
    }
    [[nodiscard]] const std::set<std::string>& tables() const { return tables_; }

 private:
    // A migration that fails on an empty store is told when it is applied.
    static void run(sqlite3* memory, const char* sql) {
        sqlite3_exec(memory, sql, nullptr, nullptr, nullptr);
    }

    void keep(sqlite3* memory) {
        RawStatement query(memory, kReadSchema);
        while (query.step() == SQLITE_ROW) {
            SchemaObject object{query.text(0), query.text(1), query.text(2), query.text(3)};
            if (object.type == "table") tables_.insert(lower(object.name));
            objects_.insert(std::move(object));
        }
    }

    std::set<SchemaObject> objects_;
    std::set<std::string> tables_;  ///< In lower case.
};

bool same(const std::vector<EmbeddedSql>& a, const std::vector<EmbeddedSql>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& two) {
        return one.name == two.name && one.text == two.text;
    });
}

/// Calls `use` with what these migrations make. This program's are worked out once.
template <class Use>
auto with_schema(const std::vector<EmbeddedSql>& migrations, const Use& use) {
    static const std::vector<EmbeddedSql> present = embedded_migrations();
    static const OwnSchema of_this_program(present);
    return migrations.empty() || same(migrations, present) ? use(of_this_program)
                                                           : use(OwnSchema(migrations));
}

/// A store that has moved away refuses every change by a trigger with its new place in it.
bool closes_the_place(const SchemaObject& object, const OwnSchema& own,
                      const std::optional<StorePlace>& place) {
    if (object.type != "trigger" || !place || !own.names_table(object.table)) return false;
    for (const char* change : {"INSERT", "UPDATE", "DELETE"})
        if (object.sql == closing_trigger(object.table, change, *place)) return true;
    return false;
}

/// Whether Placode's own statements would set it to work, or meet it in the place of a table.
bool acts(const SchemaObject& object, const OwnSchema& own) {
    if (object.type == "trigger") return true;
    if (object.type != "table") return false;
    return own.names_table(object.name) || lower(object.sql).starts_with("create virtual");
}

std::string described(const SchemaObject& object) {
    constexpr size_t kMostLetters = 60;
    const auto quoted = [](const std::string& name) {
        return "\"" + name.substr(0, kMostLetters) + "\"";
    };
    const std::string what =
        "the " + object.type.substr(0, kMostLetters) + " " + quoted(object.name);
    return object.table == object.name ? what : what + " of the table " + quoted(object.table);
}

enum class Objects : uint8_t { kAll, kThatAct };

std::string first_foreign(const std::vector<SchemaObject>& objects,
                          const std::vector<EmbeddedSql>& migrations,
                          const std::optional<StorePlace>& place, Objects which) {
    return with_schema(migrations, [&](const OwnSchema& own) -> std::string {
        for (const SchemaObject& object : objects)
            if (!own.holds(object) && !closes_the_place(object, own, place) &&
                (which == Objects::kAll || acts(object, own)))
                return described(object);
        return {};
    });
}

/// A store has recordings of up to 1 GiB, and its questions follow its size: an integrity check
/// took 0.35 steps a byte on 300 people with 20,000 attempts (66 MB).
ForeignLimits limits_of_stores(const std::string& path) {
    constexpr int64_t kStepsPerByte = 10;
    ForeignLimits limits;
    limits.longest_value_bytes = 1'000'000'000;  // SQLite's own limit.
    limits.longest_sql_bytes = 64 << 10;         // The longest of a store's has 1.3 kB.
    limits.deepest_expression = 100;             // As deep as SQLite's parser goes by itself.
    std::error_code ignored;
    const uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored) limits.most_steps += static_cast<int64_t>(size) * kStepsPerByte;
    return limits;
}

class ForeignStore {
 public:
    ForeignStore(const std::string& path, const std::string& operation)
        : operation_(operation), database_(path, limits_of_stores(path)) {
        need(database_.code(), SQLITE_OK);
        constexpr int kWait_ms = 5000;
        sqlite3_busy_timeout(database_.get(), kWait_ms);
    }

    /// @param meaning of a file that holds more, with the first of it.
    void need_own(const std::vector<EmbeddedSql>& migrations,
                  Said (*meaning)(const std::string&)) const {
        if (answer("PRAGMA application_id") != std::to_string(kStoreApplicationId))
            fail(Kind::kDamaged, "it does not bear the mark of a store");
        if (const std::string problem = database_.schema_problem(); !problem.empty())
            fail(Kind::kDamaged, "its tables cannot be read (" + problem + ")");
        const std::vector<SchemaObject> objects = read_objects();
        const std::string other =
            first_foreign(objects, migrations, place_in(objects), Objects::kAll);
        if (other.empty()) return;
        if (const std::string part = newer_part(objects, migrations); !part.empty())
            fail(Kind::kTooNew, too_new_sentence(part));
        throw StoreError(Kind::kRefused, operation_ + ": ", meaning(other));
    }

    void need_sound() const {
        if (const std::string said = answer("PRAGMA integrity_check(1)"); said != "ok")
            fail(Kind::kDamaged, said);
    }

 private:
    [[noreturn]] void fail(Kind kind, const std::string& problem) const {
        throw StoreError(kind, operation_ + ": " + problem);
    }

    void need(int code, int expected) const {
        if (code != expected)
            fail(kind_of_sqlite(code), std::string(sqlite3_errstr(code)) +
                                           "; check that it is whole and may be read by you");
    }

    [[nodiscard]] std::string answer(const char* question) const {
        RawStatement query(database_.get(), question);
        need(query.prepared() == SQLITE_OK ? query.step() : query.prepared(), SQLITE_ROW);
        return query.text(0);
    }

    [[nodiscard]] std::vector<SchemaObject> read_objects() const {
        std::vector<SchemaObject> objects;
        RawStatement query(database_.get(), kReadSchema);
        int code = query.prepared() == SQLITE_OK ? query.step() : query.prepared();
        for (; code == SQLITE_ROW; code = query.step())
            objects.push_back({query.text(0), query.text(1), query.text(2), query.text(3)});
        need(code, SQLITE_DONE);
        return objects;
    }

    /// Rows are read of tables only that are Placode's own, word for word.
    [[nodiscard]] static bool has_own(const std::vector<SchemaObject>& objects, const char* table) {
        return with_schema({}, [&](const OwnSchema& own) {
            return std::any_of(objects.begin(), objects.end(), [&](const SchemaObject& object) {
                return object.name == table && own.holds(object);
            });
        });
    }

    [[nodiscard]] std::optional<StorePlace> place_in(
        const std::vector<SchemaObject>& objects) const {
        if (!has_own(objects, kPlaceTable)) return std::nullopt;
        RawStatement query(database_.get(), "SELECT from_place, to_place FROM store_move LIMIT 1");
        if (query.prepared() != SQLITE_OK || query.step() != SQLITE_ROW) return std::nullopt;
        StorePlace place;
        place.from = query.text(0);
        place.to = query.text(1);
        return place;
    }

    /// The newest part in the store's register that this program does not know; "" = none.
    [[nodiscard]] std::string newer_part(const std::vector<SchemaObject>& objects,
                                         const std::vector<EmbeddedSql>& migrations) const {
        if (!has_own(objects, kMigrationsTable)) return {};
        std::set<std::string> known;
        for (const EmbeddedSql& each : migrations.empty() ? embedded_migrations() : migrations)
            known.insert(each.name);
        constexpr size_t kMostLetters = 60;
        RawStatement query(database_.get(),
                           "SELECT name FROM schema_migrations ORDER BY name DESC LIMIT 1000");
        while (query.step() == SQLITE_ROW)
            if (!known.contains(query.text(0))) return query.text(0).substr(0, kMostLetters);
        return {};
    }

    std::string operation_;
    ForeignDatabase database_;
};

std::string first_in(Connection& connection, const std::vector<EmbeddedSql>& migrations,
                     Objects which) {
    std::vector<SchemaObject> objects;
    Statement query(connection, kReadSchema);
    query.run();
    while (query.next())
        objects.push_back({query.text(0), query.text(1), query.text(2), query.text(3)});
    return first_foreign(objects, migrations, place_of(connection), which);
}

}  // namespace

void need_own_schema(const std::string& path, const std::string& operation,
                     const std::vector<EmbeddedSql>& migrations) {
    ForeignStore(path, operation).need_own(migrations, not_ours);
}

std::string copy_problem(const std::string& path, const std::vector<EmbeddedSql>& migrations) {
    const std::string operation = "read the copy";
    try {
        const ForeignStore store(path, operation);
        // What was not asked to be used needs no way out.
        store.need_own(migrations, [](const std::string& object) {
            return Said::as_is("it holds " + object + ", which Placode did not make");
        });
        store.need_sound();
    } catch (const StoreError& error) {
        return std::string(error.what()).substr((operation + ": ").size());
    }
    return {};
}

std::string foreign_object(Connection& connection, const std::vector<EmbeddedSql>& migrations) {
    return first_in(connection, migrations, Objects::kAll);
}

void need_nothing_that_acts(Connection& connection, const std::vector<EmbeddedSql>& migrations) {
    if (!connection.is_sqlite()) return;
    if (const std::string other = first_in(connection, migrations, Objects::kThatAct);
        !other.empty())
        connection.fail(Kind::kRefused, not_ours(other));
}

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_place.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace placode::db {
namespace {

using State = StorePlace::State;

constexpr std::array<const char*, 3> kStates{"arriving", "ready", "moved"};

bool has_place(Connection& connection) {
    Statement query(connection,
                    connection.is_sqlite()
                        ? "SELECT COUNT(*) FROM sqlite_schema WHERE type = 'table' AND name = ?"
                        : "SELECT COUNT(*) FROM pg_tables WHERE schemaname = current_schema() AND "
                          "tablename = ?");
    return query.run(kPlaceTable).next() && query.integer(0) > 0;
}

Said moved_sentence(const StorePlace& place) {
    return Said::that("the store was moved to %1; use that address, or bring it back with `%2`")
        .with(place.to)
        .with(move_command(place.to, place.from));
}

std::string in_quotes(std::string text) {
    for (size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 2))
        text.insert(at, 1, '\'');
    return "'" + text + "'";
}

/// "postgresql://USER@" is left out: the owner moves a store, stations use it.
std::string without_user(const std::string& place) {
    const size_t at = place.find('@'), begin = place.find("://");
    return at == std::string::npos || begin == std::string::npos
               ? place
               : place.substr(0, begin + 3) + place.substr(at + 1);
}

}  // namespace

std::optional<StorePlace> place_of(Connection& connection) {
    if (!has_place(connection)) return std::nullopt;
    Statement query(connection,
                    std::string("SELECT state, from_place, to_place, store, entry, chain, at_utc "
                                "FROM ") +
                        kPlaceTable);
    if (!query.run().next()) return std::nullopt;
    StorePlace place;
    const auto* state = std::find(kStates.begin(), kStates.end(), query.text("state"));
    if (state == kStates.end())
        connection.fail(StoreError::Kind::kTooNew,
                        "the store was moved by a newer program; update Placode");
    place.state = static_cast<State>(state - kStates.begin());
    place.from = query.text("from_place");
    place.to = query.text("to_place");
    place.store = query.text("store");
    place.entry = query.integer("entry");
    place.chain = query.text("chain");
    place.at_utc = query.text("at_utc");
    return place;
}

void set_place(Connection& connection, const StorePlace& place) {
    if (!has_place(connection)) {
        connection.execute(kCreatePlaceTable);
        // A station's log-in is told as well.
        if (!connection.is_sqlite())
            connection.execute(std::string("GRANT SELECT ON ") + kPlaceTable + " TO PUBLIC");
    }
    connection.execute(std::string("DELETE FROM ") + kPlaceTable);
    Statement(connection,
              std::string("INSERT INTO ") + kPlaceTable +
                  " (state, from_place, to_place, store, entry, chain, at_utc) VALUES (?, ?, ?, ?, "
                  "?, ?, ?)")
        .run(kStates[static_cast<size_t>(place.state)], place.from, place.to, place.store,
             place.entry, place.chain, place.at_utc);
}

void forget_place(Connection& connection) {
    connection.execute(std::string("DROP TABLE IF EXISTS ") + kPlaceTable);
}

void need_settled(Connection& connection) {
    const auto place = place_of(connection);
    if (!place) return;
    connection.fail(
        StoreError::Kind::kRefused,
        place->state == State::kMoved
            ? moved_sentence(*place)
            : Said::that(
                  "a store is being moved here from %1, and that is not finished; go on with `%2`")
                  .with(place->from)
                  .with(move_command(place->from, place->to)));
}

std::optional<Said> moved_meanwhile(Connection& connection) {
    try {
        const auto place = place_of(connection);
        if (!place || place->state != State::kMoved) return std::nullopt;
        return Said::that(
                   "the store was moved to %1; use that address, or bring it back with `%2`; "
                   "nothing was changed")
            .with(place->to)
            .with(move_command(place->to, place->from));
    } catch (const StoreError&) {
        return std::nullopt;  // The engine's own text says it.
    }
}

void close_place(Connection& connection, const StorePlace& place,
                 const std::vector<StoreTable>& tables) {
    set_place(connection, place);
    std::vector<std::string> names{kPlaceTable, kMigrationsTable};
    for (const StoreTable& table : tables) names.push_back(table.name);
    if (!connection.is_sqlite())
        connection.execute(
            "CREATE FUNCTION store_was_moved() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RAISE "
            "EXCEPTION USING MESSAGE = " +
            in_quotes(moved_sentence(place).english()) + "; END $$");
    for (const std::string& name : names) {
        if (!connection.is_sqlite()) {
            connection.execute("CREATE TRIGGER " + name +
                               "_has_moved BEFORE INSERT OR UPDATE OR DELETE OR TRUNCATE ON " +
                               name + " FOR EACH STATEMENT EXECUTE FUNCTION store_was_moved()");
            continue;
        }
        for (const char* change : {"INSERT", "UPDATE", "DELETE"})
            connection.execute(closing_trigger(name, change, place));
    }
}

std::string closing_trigger(const std::string& table, const std::string& change,
                            const StorePlace& place) {
    return "CREATE TRIGGER " + table + "_has_moved_" + change + " BEFORE " + change + " ON " +
           table + " BEGIN SELECT RAISE(ABORT, " + in_quotes(moved_sentence(place).english()) +
           "); END";
}

std::string place_name(const StoreUrl& url) {
    if (url.engine == Engine::kSqlite)
        return "sqlite:" + std::filesystem::weakly_canonical(url.path).string();
    const std::string user = url.user.empty() ? "" : url.user + "@";
    const std::string behind = ":" + std::to_string(url.port) + "/" + url.name;
    if (url.host.find('/') != std::string::npos)
        return "postgresql://" + user + "/" + url.name + "?host=" + url.host;
    return "postgresql://" + user +
           (url.host.find(':') == std::string::npos ? url.host : "[" + url.host + "]") + behind;
}

bool same_place(const std::string& a, const std::string& b) {
    return without_user(a) == without_user(b);
}

std::string move_command(const std::string& from, const std::string& to) {
    const auto word = [](const std::string& place) {
        return place.find_first_of(" &?'") == std::string::npos ? place : "\"" + place + "\"";
    };
    // Nobody is administrator of a server just by being at it.
    const std::string who = from.starts_with("postgresql:") ? " --as LOGIN" : "";
    return "placodectl --store " + word(from) + who + " store move --to " + word(to);
}

std::string first_chain(Connection& connection) {
    Statement first(connection, "SELECT chain FROM audit ORDER BY id LIMIT 1");
    return first.run().next() ? first.text("chain") : std::string();
}

}  // namespace placode::db

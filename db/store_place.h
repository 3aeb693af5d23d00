// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store that is moving to another place, or has moved (db/store_move.h), says so in a table that
// only such a store has: no program opens it then. Only db/ includes this.

#include <cstdint>
#include <optional>
#include <string>

#include "db/said.h"
#include "db/store_tables.h"

namespace placode::db {

inline constexpr const char* kPlaceTable = "store_move";
inline constexpr const char* kCreatePlaceTable =
    "CREATE TABLE store_move (state TEXT PRIMARY KEY, from_place TEXT NOT NULL, to_place TEXT NOT "
    "NULL, store TEXT NOT NULL, entry BIGINT NOT NULL, chain TEXT NOT NULL, at_utc TEXT NOT NULL)";

struct StorePlace {
    enum class State : uint8_t {
        kArriving,  ///< Not all of it is here yet.
        kReady,     ///< All is here and was compared; the old place has to be closed first.
        kMoved,     ///< This is the old place.
    };
    State state = State::kArriving;
    std::string from, to;  ///< Addresses for people, without passwords (place_name()).
    std::string store;     ///< Chain of the trail's first entry: which store it is.
    /// The trail's last entry that is copied; "" = what is here is thrown away first.
    int64_t entry = 0;
    std::string chain;
    std::string at_utc;
};

[[nodiscard]] std::optional<StorePlace> place_of(Connection& connection);
/// Within a transaction.
void set_place(Connection& connection, const StorePlace& place);
void forget_place(Connection& connection);

/// Throws kRefused for a store that is moving or has moved, naming both places and the command that
/// goes on, or back.
void need_settled(Connection& connection);
/// For Connection::explain_refusals(): what the triggers of close_place() say to a program that had
/// the store open; nullopt where the store did not move.
[[nodiscard]] std::optional<Said> moved_meanwhile(Connection& connection);

/// Within a transaction: set_place(), and from the commit on the engine refuses every change of
/// every table, also by programs that have the store open.
void close_place(Connection& connection, const StorePlace& place,
                 const std::vector<StoreTable>& tables);

/// In a file the trigger that refuses one kind of change ("INSERT") of one table.
[[nodiscard]] std::string closing_trigger(const std::string& table, const std::string& change,
                                          const StorePlace& place);

/// The address as both places keep it: a full path, a port, no password and no options but the
/// folder of a socket.
[[nodiscard]] std::string place_name(const StoreUrl& url);
/// Of two such names, whoever signs in there.
[[nodiscard]] bool same_place(const std::string& a, const std::string& b);
/// What moves a store from one to the other.
[[nodiscard]] std::string move_command(const std::string& from, const std::string& to);

/// Chain of the first entry of the trail, which tells the store from every other one; "" in an
/// empty one.
[[nodiscard]] std::string first_chain(Connection& connection);

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What only some programs, and tests, set when they open a store.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "db/migrations.h"

namespace placode::db {

/// What an update of an older store does, in this order; on a server the last two only.
enum class UpdatePart : uint8_t {
    kCheck,   ///< Reads the whole file.
    kCopy,    ///< Keeps the store as it is beside it.
    kTables,  ///< Changes the tables, all of them or none.
    kSeals    ///< Seals what is there: only a store from before there were seals.
};
struct UpdateStep {
    UpdatePart part = UpdatePart::kCheck;
    std::string copy;  ///< kTables: where the store as it was is kept; "" on a server.
};

struct StoreOptions {
    bool cheap_passwords = false;     ///< Tests: weakest Argon2id, because hashing takes 50 ms.
    std::function<int64_t()> now_ms;  ///< Clock of the sign-in waits [ms]; empty = the system's.
    std::vector<EmbeddedSql> migrations;  ///< Empty = embedded_migrations().
    /// It was there before, by what the caller remembers: a missing file is kMissing. A store that
    /// has had accounts also says so itself, by the mark beside its file.
    bool known = false;
    bool begin_anew = false;  ///< On purpose: make a new store where a known one is missing.
    /// For people at a station: where a centre's server has the group for stations
    /// (db/station_role.h), a log-in that can do more is refused.
    bool station = false;
    /// With `station`: a program that acts for people who sign in elsewhere, as a learning platform
    /// lets them in. On a server it needs the log-in of a service (placode_service).
    bool service = false;
    /// Leaves the tables of an older program as they are and throws kOlder: an update reads and
    /// writes the whole store, and somebody may be waiting at a window.
    bool leave_older = false;
    /// Told before each step of an update, on the thread that opens the store.
    std::function<void(const UpdateStep&)> updating;
    /// Tests: as if the disk of a copy had this much room [bytes].
    std::optional<int64_t> room_bytes;
    /// For people anywhere: wrong passwords are counted, and waited for, apart from those that are
    /// typed at stations. Whoever reaches the portal keeps nobody out of a station.
    bool portal = false;
};

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What only tests and special programs set when they open a store.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "db/migrations.h"

namespace placode::db {

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
    /// Tests: as if the disk of a copy had this much room [bytes].
    std::optional<int64_t> room_bytes;
    /// For people anywhere: wrong passwords are counted, and waited for, apart from those that are
    /// typed at stations. Whoever reaches the portal keeps nobody out of a station.
    bool portal = false;
};

}  // namespace placode::db

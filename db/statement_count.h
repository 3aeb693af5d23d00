// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How often the store asks its database: each statement is a round trip to a server.

#include <cstdint>

namespace placode::db {

/// Statements that this thread has sent to databases so far, those of transactions included. Tests
/// compare it before and after: it must not grow with the rows.
inline int64_t& statements_sent() noexcept {
    thread_local int64_t sent = 0;
    return sent;
}

}  // namespace placode::db

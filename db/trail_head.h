// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where an audit trail ended, stated and signed by a computer that had the store open. Kept apart
// from the store (beside a backup, printed, in a letter), it shows whoever cuts the trail off or
// writes it anew afterwards, with whatever keys.

#include <cstdint>
#include <string>

namespace placode::db {

struct TrailHead {
    std::string store;    ///< Chain of the first entry, which tells the store from every other one.
    int64_t entry = 0;    ///< Number of the last one; 0 = none was there.
    std::string chain;    ///< Of that entry.
    std::string at_utc;   ///< When it was stated.
    std::string station;  ///< Public key of who states it; "" = a computer without a key.
    std::string signature;  ///< Over trail_statement(); "" without a key.
};

/// What is signed: five lines of words, for people and programs.
[[nodiscard]] std::string trail_statement(const TrailHead& head);

/// The statement, then the signature. As it is kept.
[[nodiscard]] std::string trail_head_text(const TrailHead& head);

/// Back from its text. Throws StoreError(kDamaged), which begins with `name`, for what is no
/// statement and for one whose signature is not right.
[[nodiscard]] TrailHead trail_head_of(const std::string& text, const std::string& name);

/// Where the statement of a backup is kept: beside it.
[[nodiscard]] inline std::string head_file_of(const std::string& backup) {
    return backup + ".head";
}

/// Durably, never over a file that is there. Throws StoreError.
void write_trail_head(const TrailHead& head, const std::string& path);
[[nodiscard]] TrailHead read_trail_head(const std::string& path);

}  // namespace placode::db

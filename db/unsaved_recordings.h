// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recordings that a crash left before anybody saved them. An order beside each says whose it is
// (db/recording_order.h).

#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

/// Where an embedded store's recordings lie until they are saved; "" of a server, where each
/// computer has a folder of its own.
[[nodiscard]] std::string recordings_beside(const std::string& url);

enum class Unsaved : uint8_t { kName, kRemove };
/// Recordings in that folder which a crash left of a participant: nothing more is saved of who has
/// withdrawn. kRemove: they go, with the files that say whose they are. One that is being written
/// is left out.
std::vector<std::string> unsaved_recordings(const std::string& folder, const StudyContext& whose,
                                            Unsaved what);

/// What there was of a person who is erased.
struct UnsavedOf {
    std::vector<std::string> removed;  ///< Recordings of the person.
    std::vector<std::string> naming;  ///< Orders of other attempts that name the person; they stay.
};
/// Removes the person's recordings in that folder, but for those of a study, with their orders.
UnsavedOf remove_unsaved_of(const UserRecord& user, const std::string& folder);

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a participant agreed to.

#include <string>

#include "db/store.h"

namespace placode::db {

/// Whether the participant's consent, the last that was recorded, names the statement ("data") of
/// the protocol. False for who gave none, and for who withdrew and wanted the data unused.
[[nodiscard]] bool has_agreed(Store& store, const std::string& study_id, const std::string& code,
                              const std::string& statement);

}  // namespace placode::db

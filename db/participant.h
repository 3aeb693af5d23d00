// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pseudonymous codes of participants: "P001-K". The last letter catches every single wrong digit
// and every swap of two neighbours.

#include <string>

namespace placode::db {

/// @pre number > 0.
[[nodiscard]] std::string participant_code(int number);

/// True for a code whose check letter fits. Case matters not.
[[nodiscard]] bool valid_participant_code(const std::string& code);

}  // namespace placode::db

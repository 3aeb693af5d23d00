// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is said to people, as the store keeps it.

#include <QJsonObject>

#include "db/said.h"

namespace placode::db {

/// {"says":"%1 of %2","with":[...]} for a sentence and what fills its places; {"text":"x"} for what
/// is as it is, with "pl" beside it where it has Polish of its own; {} for nothing.
[[nodiscard]] QJsonObject said_json(const Said& said);
/// What is no such object says nothing. Never throws.
[[nodiscard]] Said said_of_json(const QJsonObject& json);

}  // namespace placode::db

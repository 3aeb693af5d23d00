// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a reason means, as the store keeps it.

#include <string>

#include "assessment/reason.h"

namespace placode::db {

/// {"pattern":{"en":...,"pl":...},"metric":...,"value":"12.5","count":3,"hour":4}. The value is
/// text, so that what is not finite is kept, and every bit of what is. Of a slit also
/// "between":[2,3], which older programs leave aside, and "upright":true where its ends are.
[[nodiscard]] std::string reason_json(const assessment::ReasonMeaning& meaning);
/// Throws StoreError(kDamaged) for what is no such text; "" is a reason of an older program.
[[nodiscard]] assessment::ReasonMeaning reason_from_json(const std::string& json);

}  // namespace placode::db

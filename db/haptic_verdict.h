// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The haptic certificate of an attempt when it is saved: what is kept of it, and whether an exam is
// void for cause.

#include <string>
#include <vector>

#include "db/records.h"
#include "db/void_reason.h"

namespace placode::db {

struct HapticVerdict {
    std::string certificate;        ///< JSON; empty: none was kept.
    std::string grade;              ///< As haptics::grade_name; empty: none was kept.
    std::vector<VoidReason> voids;  ///< Why an exam attempt does not count; empty: it does.
};

/// Takes the certificate from `result` or, where that is empty, from the recording file. One that
/// is damaged counts as bad. Throws StoreError where it cannot be read just now (may_pass()).
[[nodiscard]] HapticVerdict haptic_verdict(const AttemptResult& result);

}  // namespace placode::db

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether an attempt that is being saved as an exam is the one that was begun, asked within the
// transaction that saves it. Attempts, case and assignment were asked when it began; of one that
// was begun elsewhere, as of an import, they are looked up now.

#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

struct StoreContext;

/// By how much the clocks of station and store may differ [s].
inline constexpr int64_t kClockAllowanceS = 300;

struct ExamCheck {
    int64_t begin = 0;    ///< The begin that the attempt ends; 0 = none.
    std::string proctor;  ///< As the store keeps it, "user 12"; empty = none was named.
    std::vector<VoidReason> doubts;
};

/// Within the transaction that saves it. Of practice only the time is looked at, and whether its
/// version of the task had been replaced. An import has no begin: a proctor vouches for it, or an
/// administrator who saves it; never the examined person, nor a program alone. Throws StoreError.
[[nodiscard]] ExamCheck check_exam(StoreContext& context, const UserRecord& user,
                                   const AttemptResult& result);

}  // namespace placode::db

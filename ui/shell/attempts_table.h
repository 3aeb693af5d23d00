// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The table of attempts that History and Attempts share: newest first, sortable, a row knows its
// attempt.

#include <vector>

#include "ui/shell/parts.h"

namespace placode::ui {

enum class AttemptColumns : uint8_t {
    kOwn,       ///< Of one person at one task.
    kEverybody  ///< With person and task.
};

[[nodiscard]] QTableWidget* make_attempts_table(AppContext& context,
                                                const std::vector<db::AttemptRecord>& attempts,
                                                AttemptColumns columns);

/// Where none of `attempts` (at one task) counts: why the chart is empty, and what to do.
[[nodiscard]] QString why_nothing_counts(const std::vector<db::AttemptRecord>& attempts);

/// The same for a list of many people's attempts, without advice.
[[nodiscard]] QString why_nobody_counts(const std::vector<db::AttemptRecord>& attempts);

/// Attempt id of a row, however the table is sorted.
[[nodiscard]] int64_t attempt_of_row(const QTableWidget* table, int row);

}  // namespace placode::ui

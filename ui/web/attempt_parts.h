// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pages of one attempt show alike.

#include "assessment/ledger.h"
#include "db/store.h"
#include "reports/attempt_figures.h"
#include "ui/web/html.h"

namespace placode::web {

/// Empty where the task ships no more: then all that was measured is shown.
[[nodiscard]] reports::TaskScope scope_of_task(const db::AttemptDetail& detail);
/// The damage ledger, from the events that the store keeps beside the recording.
[[nodiscard]] reports::LedgerPicture ledger_of(const db::AttemptDetail& detail,
                                               const reports::TaskScope& scope);
/// "Placode touched, ..., 4 o'clock", with a mark where it is critical.
[[nodiscard]] Html entry_words(const assessment::LedgerEntry& entry);

}  // namespace placode::web

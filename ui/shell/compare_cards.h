// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cards of the page that compares two attempts at a task: how each ended, and their measures side
// by side.

#include <QFrame>

#include "db/records.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// Points, verdict and the three reasons that cost most; or why the attempt does not count.
/// @param name of the attempt. @param place 0 or 1.
[[nodiscard]] QFrame* make_compare_head(const db::AttemptDetail& attempt, const QString& name,
                                        size_t place);

/// Measures that both have, and which is better where both count.
[[nodiscard]] QFrame* make_compare_metrics(AppContext& context, const db::AttemptDetail& first,
                                           const db::AttemptDetail& second);

}  // namespace placode::ui

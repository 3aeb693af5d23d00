// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paper about people in training (reports/cohort_report.h), from the pages that show them.

#include <functional>

#include "ui/shell/app_context.h"

class QPushButton;

namespace placode::ui {

class Page;

/// Writes the report of everybody or, from its list, of one of the groups that the user may see.
[[nodiscard]] QPushButton* make_cohort_report_button(AppContext& context, Page& page);

/// Writes the report of the trainee whom `chosen` names when it is pressed; account 0 = nobody.
[[nodiscard]] QPushButton* make_trainee_report_button(AppContext& context, Page& page,
                                                      const QString& text,
                                                      std::function<qint64()> chosen);

}  // namespace placode::ui

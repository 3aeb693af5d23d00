// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "reports/study_analysis.h"

namespace placode::ui {

/// The numbers of an analysis, in the order in which they were computed until somebody sorts them.
[[nodiscard]] QTableWidget* make_analysis_table(const reports::Analysis& found);

}  // namespace placode::ui

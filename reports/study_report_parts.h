// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chapters of the study report beside study_report.cpp. Private to reports.

#include "reports/paper.h"
#include "reports/study_report.h"

namespace placode::reports {

/// Construct validity, test-retest, learning curves, agreement of raters, as far as there are data.
void write_analyses(Paper& paper, const StudyReport& report);
/// Where things did not go as the protocol says: how many of each kind, and every one by code.
void write_deviations(Paper& paper, const StudyReport& report);
/// Amendments of the protocol, corrections, locks, and who signed what when and meaning what.
void write_data_care(Paper& paper, const StudyReport& report);

}  // namespace placode::reports

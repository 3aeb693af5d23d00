// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chapters of the study report beside study_report.cpp. Private to reports.

#include "reports/paper.h"
#include "reports/study_report.h"

namespace placode::reports {

/// A text of the study within the paper's HTML.
/// "A1  The picture is lifelike": with the id where it is short enough to be a name.
[[nodiscard]] inline std::string item_label(const Field& field) {
    return field.id.size() <= 2 ? field.id + "  " + field.label : field.label;
}

/// Title, version of the protocol and date; says when the participants were simulated.
void write_title(Paper& paper, const StudyReport& report);
/// What participants went through, the instruments, the statistics.
void write_methods(Paper& paper, const StudyReport& report);
/// Software, data and checksums of the definitions.
void write_versions(Paper& paper, const StudyReport& report);

/// Numbers and choices of a form, as far as anybody answered.
void write_choices(Paper& paper, const FormNumbers& form);
/// Likert items of a form.
void write_items(Paper& paper, const FormNumbers& form);
/// Scale scores of a form with Cronbach's alpha.
void write_scales(Paper& paper, const FormNumbers& form);
/// Items between two groups of participants, where the study has them.
void write_comparison(Paper& paper, const StudyNumbers& numbers);

/// Construct validity, test-retest, learning curves, agreement of raters, as far as there are data.
void write_analyses(Paper& paper, const StudyReport& report);
/// Where things did not go as the protocol says: how many of each kind, and every one by code.
void write_deviations(Paper& paper, const StudyReport& report);
/// Amendments of the protocol, corrections, locks, and who signed what when and meaning what.
void write_data_care(Paper& paper, const StudyReport& report);

}  // namespace placode::reports

// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The report of a study on A4, ready to attach to a paper: methods, flow of participants, tables,
// figures, what the sample cannot carry, versions.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/study_records.h"
#include "reports/dataset.h"
#include "reports/dataset_protocols.h"
#include "reports/export_pace.h"
#include "reports/figure.h"
#include "reports/pass_marks.h"
#include "reports/study_numbers.h"

namespace placode::reports {

struct StudyReport {
    Dataset data;
    std::vector<curriculum::Questionnaire> instruments;  ///< Of the data set's forms.
    std::vector<db::StepRecord> steps;
    std::vector<db::ParticipantRecord> everybody;  ///< With those who left.
    Protocols protocols;                           ///< By which everybody's steps are read.
    std::vector<db::DefinitionRecord> versions;    ///< Of the protocol: amendments with reasons.
    std::vector<db::RecordEvent> record_events;
    std::map<std::string, db::RecordState> record_states;
    std::vector<db::Correction> corrections;
    std::vector<db::RatingRecord> ratings;  ///< By the OSATS form, of all attempts.
    PassMarks pass_marks;

    [[nodiscard]] std::optional<double> pass_mark(const std::string& task) const {
        return pass_marks.of(task);
    }
};

/// Reads what the report needs. Throws ReportError as study_dataset() does.
[[nodiscard]] StudyReport read_study_report(db::Store& store, const std::string& study_id,
                                            const std::string& language = "en");

/// Of everybody who was enrolled, each by the version of the protocol of the enrolment; consented
/// is -1 where no such version asks for one. Steps stand in the order of the newest of these
/// versions, those of an earlier one only behind the step that they followed.
/// @param language of the steps' titles.
[[nodiscard]] FlowNumbers flow_numbers(const StudyReport& report,
                                       const std::string& language = "en");

/// All figures that the data allow. The figures do not refer to `report`.
[[nodiscard]] std::vector<Figure> study_figures(const StudyReport& report,
                                                const StudyNumbers& numbers,
                                                const ChartStyle& style = {});

/// Needs a QGuiApplication. Throws ReportError, or ExportStopped where `pace` said so; the file is
/// then as it was.
void write_study_pdf(const StudyReport& report, const std::string& path,
                     const ExportPace& pace = {});

/// Every figure as SVG, PNG and CSV, and numbers.csv: all of them, or the folder is as it was
/// (staged_folder.h). Returns the paths. Throws ReportError, or ExportStopped before any figure.
std::vector<std::string> write_study_figures(const StudyReport& report, const std::string& folder,
                                             const ExportPace& pace = {});

}  // namespace placode::reports
